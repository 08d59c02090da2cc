// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLShaderProgram>
#include <QStringList>

#include "core/models/model.h"

/// Models in the shaders: functions around their formulas (core/models/*.glsl), and their parameters.
namespace gonio::widgets {

/// Name of a model in the shaders, e.g. "ggx_anisotropic".
QString modelName(const models::Model& model);
/// The function that evaluates a model, e.g. "evaluate_ggx": `vec3 evaluate_ggx(vec3 wi, vec3 wo, vec4 p[N])`, with
/// Model::shaderParameters(). Directions are unit vectors away from the surface; the value is 0 where that in C++ is.
QString modelFunction(const models::Model& model);
/// The file of a model for #include, "models/ggx_anisotropic", which ShaderLibrary takes from modelShader().
QString modelFile(const models::Model& model);
/// The GLSL of a model: its formula and the function modelFunction(). For a sum of N lobes also
/// `lobes_ID(vec3 wi, vec3 wo, vec4 p[], out vec3 lobes[N])`, of which the value is the sum.
QByteArray modelShader(const models::Model& model);

/// The declaration of the parameters of a model as a uniform, e.g. "uniform vec4 edited0[4];".
QString modelUniform(const models::Model& model, const QString& name);
/// Sets this uniform in the bound program.
void setModelUniform(QOpenGLShaderProgram& program, const QString& name, const models::Model& model,
                     const models::ParameterValues& values);

/// Adds the definitions and files of a shader that contains a model's formula.
void addModel(const models::Model& model, QStringList& definitions, QStringList& preamble);
/// The same for a shader that evaluates the model in place of a base, with the uniform "modelParameters".
void addModelAlone(const models::Model& model, QStringList& definitions, QStringList& preamble);

}  // namespace gonio::widgets
