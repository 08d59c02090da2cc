// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLShaderProgram>
#include <QStringList>

#include "core/models/model.h"

/// Models in the shaders: their functions (shaders/models) and their parameters.
namespace gonio::widgets {

/// Name of a model in the shaders, e.g. "ggx_anisotropic".
QString modelName(const models::Model& model);
/// The function of shaders/models that evaluates a model, e.g. "evaluate_ggx".
QString modelFunction(const models::Model& model);
/// The file with this function, e.g. "models/ggx.glsl".
QString modelFile(const models::Model& model);

/// The parameters of a model as one uniform. They are packed into vectors of four: three components for a colour, one
/// for any other parameter. In the shader, `name` expands to the array of vec3 that the model's function takes.
struct ModelUniform {
  QString declaration;  ///< "uniform vec4 packed_edited0[9];"
  QString definition;   ///< "edited0 vec3[18](...)", for a #define
};
ModelUniform modelUniform(const models::Model& model, const QString& name);
/// Sets this uniform in the bound program.
void setModelUniform(QOpenGLShaderProgram& program, const QString& name, const models::Model& model,
                     const models::ParameterValues& values);

/// Adds the definitions and files of a shader that contains a model's formula.
void addModel(const models::Model& model, QStringList& definitions, QStringList& preamble);
/// The same for a shader that evaluates the model in place of a base, with the uniform "modelParameters".
void addModelAlone(const models::Model& model, QStringList& definitions, QStringList& preamble);

}  // namespace gonio::widgets
