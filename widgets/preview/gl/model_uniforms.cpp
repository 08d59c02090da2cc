// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/model_uniforms.h"

#include <vector>

namespace gonio::widgets {

namespace {

/// Around a formula that returns the value; %1 name, %2 vectors, %3 arguments.
constexpr const char* evaluateFunction = R"(
vec3 evaluate_%1(vec3 wi, vec3 wo, vec4 p[%2]) {
  SurfaceGeometry g;
  return surfaceGeometry(wi, wo, g) ? formula_%1(g, %3) : vec3(0.0);
}
)";

/// Around a formula that returns %4 lobes; %5 their sum.
constexpr const char* lobesFunctions = R"(
void lobes_%1(vec3 wi, vec3 wo, vec4 p[%2], out vec3 lobes[%4]) {
  SurfaceGeometry g;
  for (int i = 0; i < %4; ++i) lobes[i] = vec3(0.0);
  if (surfaceGeometry(wi, wo, g)) formula_%1(g, %3, lobes);
}

vec3 evaluate_%1(vec3 wi, vec3 wo, vec4 p[%2]) {
  vec3 lobes[%4];
  lobes_%1(wi, wo, p, lobes);
  return %5;
}
)";

}  // namespace

QString modelName(const models::Model& model) { return QString::fromStdString(model.spec().shaderName()); }

QString modelFunction(const models::Model& model) { return "evaluate_" + modelName(model); }

QString modelFile(const models::Model& model) { return "models/" + modelName(model); }

QByteArray modelShader(const models::Model& model) {
  const QString includes = QStringLiteral("#include \"formula.glsl\"\n#include \"%1\"\n")
                               .arg(QString::fromStdString(model.spec().formulaFile()));
  const QString arguments = QString::fromStdString(model.shaderArguments());
  QString functions = QString(model.hasLobes() ? lobesFunctions : evaluateFunction)
                          .arg(modelName(model))
                          .arg(model.shaderVectors())
                          .arg(arguments);
  if (model.hasLobes()) {
    QStringList lobes;
    for (std::size_t i = 0; i < model.lobes(models::defaultParameters(model.spec())).size(); ++i)
      lobes << QString("lobes[%1]").arg(i);
    functions = functions.arg(lobes.size()).arg(lobes.join(" + "));
  }
  return (includes + functions).toUtf8();
}

QString modelUniform(const models::Model& model, const QString& name) {
  return QString("uniform vec4 %1[%2];").arg(name).arg(model.shaderVectors());
}

void setModelUniform(QOpenGLShaderProgram& program, const QString& name, const models::Model& model,
                     const models::ParameterValues& values) {
  const std::vector<glm::vec4> packed = model.shaderParameters(values);
  program.setUniformValueArray(name.toUtf8().constData(), &packed.front().x, int(packed.size()), 4);
}

void addModel(const models::Model& model, QStringList& definitions, QStringList& preamble) {
  definitions << "EVALUATE_MODEL " + modelFunction(model);
  preamble << modelFile(model);
}

void addModelAlone(const models::Model& model, QStringList& definitions, QStringList& preamble) {
  definitions << "MODEL_ALONE"
              << "MODEL_UNIFORM " + modelUniform(model, "modelParameters");
  addModel(model, definitions, preamble);
}

}  // namespace gonio::widgets
