// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLShaderProgram>
#include <QStringList>

#include "core/models/model.h"

/// Models in the shaders: their functions (shaders/models) and their parameters.
namespace gonio::widgets {

/// "ggx_anisotropic": its name in the shaders.
QString modelName(const models::Model& model);
/// "evaluate_ggx": the function of shaders/models that evaluates a model.
QString modelFunction(const models::Model& model);
/// "models/ggx.glsl": the file that it is in.
QString modelFile(const models::Model& model);

/// The parameters of a model as a uniform: packed into vectors of four, so that no component is stored or read twice.
/// In the shader `name` is an expression for the array of vec3 that the model's function takes.
struct ModelUniform {
  QString declaration;  ///< "uniform vec4 packed_edited0[9];"
  QString definition;   ///< "edited0 vec3[18](...)", for a #define
};
ModelUniform modelUniform(const models::Model& model, const QString& name);
/// Sets it in the bound program.
void setModelUniform(QOpenGLShaderProgram& program, const QString& name, const models::Model& model,
                     const models::ParameterValues& values);

}  // namespace gonio::widgets
