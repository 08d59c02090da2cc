// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLShaderProgram>

#include "core/editing/albedo_scale.h"
#include "core/editing/differential_edit.h"

/// An edit by lobes in the shader: the counterpart of editing::LobeChange, inserted by EditChain. The generated code
/// contains only the parts of the model that change, because loops and conditions are slow in software OpenGL even if
/// they skip work. Hence the first move of a slider compiles a new variant.
namespace gonio::widgets {

/// Declarations of its uniforms, except the parameters of the model and the strength. @param number index of the edit
/// in the chain.
QString lobeUniforms(const editing::DifferentialEdit& edit, int number);
/// The code of its function. @param name of the function; @param previous name of the preceding function.
QString lobeStage(const QString& name, const QString& previous, const editing::DifferentialEdit& edit, int number);
/// @param scale of the edit: editing::albedoScales().
void setLobeUniforms(QOpenGLShaderProgram& program, const QString& number, const editing::DifferentialEdit& edit,
                     const editing::AlbedoScale& scale);

}  // namespace gonio::widgets
