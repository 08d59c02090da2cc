// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace gonio::widgets {

/// Source of a shader in shaders/, e.g. "preview/scene.frag", with its #include "file" lines replaced by those files
/// (each once, after a comment with its name): files of shaders/, formulas "core/models/FILE.glsl", and the models of
/// modelFile(). Read from the program's resources or, during development, from the folder of the sources in
/// GONIO_SHADER_DIR.
/// @throws gonio::Error that names the missing file.
QByteArray shaderText(const QString& name);

/// A complete shader: the version line, a #define for each of `definitions` ("NAME" or "NAME value"), the texts of
/// `preamble` files, then the file itself.
/// @throws gonio::Error that names the missing file.
QByteArray assembleShader(const QString& name, const QStringList& definitions = {}, const QStringList& preamble = {});

}  // namespace gonio::widgets
