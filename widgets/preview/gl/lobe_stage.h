// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLShaderProgram>

#include "core/editing/differential_edit.h"

/// An edit that is composed by lobes in the shader: twin of editing::LobeChange. EditChain puts it among the others.
/// The text holds only the parts of the model that there are, and what happens to them: software OpenGL pays for loops
/// and conditions even where they skip something. So a slider is compiled for when it is first moved.
namespace gonio::widgets {

/// Its uniforms beside the parameters of the model and the strength. @param number of the edit in the chain.
QString lobeUniforms(const editing::DifferentialEdit& edit, int number);
/// The text of its function. @param name of it; @param previous the function before it.
QString lobeStage(const QString& name, const QString& previous, const editing::DifferentialEdit& edit, int number);
void setLobeUniforms(QOpenGLShaderProgram& program, const QString& number, const editing::DifferentialEdit& edit);

}  // namespace gonio::widgets
