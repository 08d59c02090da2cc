// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/model_uniforms.h"

#include <vector>

namespace gonio::widgets {

namespace {

QString packedName(const QString& name) { return "packed_" + name; }

/// Vectors of four that hold so many components.
int vectorsFor(int components) { return (components + 3) / 4; }

/// "packed_edited0[1].w" for the component 7.
QString componentText(const QString& name, int component) {
  return QString("%1[%2].%3").arg(packedName(name)).arg(component / 4).arg("xyzw"[component % 4]);
}

}  // namespace

QString modelName(const models::Model& model) {
  return QString::fromUtf8(model.spec().id.data(), qsizetype(model.spec().id.size())).replace('-', '_');
}

QString modelFunction(const models::Model& model) { return "evaluate_" + modelName(model); }

QString modelFile(const models::Model& model) { return "models/" + modelName(model).replace('_', '-') + ".glsl"; }

ModelUniform modelUniform(const models::Model& model, const QString& name) {
  QStringList entries;
  int next = 0;
  for (const int count : model.shaderComponents()) {
    QStringList parts;
    for (int i = 0; i < count; ++i) parts << componentText(name, next++);
    entries << "vec3(" + parts.join(", ") + ')';
  }
  return {QString("uniform vec4 %1[%2];").arg(packedName(name)).arg(vectorsFor(next)),
          QString("%1 vec3[%2](%3)").arg(name).arg(entries.size()).arg(entries.join(", "))};
}

void setModelUniform(QOpenGLShaderProgram& program, const QString& name, const models::Model& model,
                     const models::ParameterValues& values) {
  const std::span<const int> components = model.shaderComponents();
  const std::vector<glm::vec3> entries = model.shaderParameters(values);
  std::vector<float> packed;
  for (std::size_t i = 0; i < entries.size(); ++i)
    for (int c = 0; c < components[i]; ++c) packed.push_back(entries[i][c]);
  const int vectors = vectorsFor(int(packed.size()));
  packed.resize(4 * std::size_t(vectors));
  program.setUniformValueArray(packedName(name).toUtf8().constData(), packed.data(), vectors, 4);
}

void addModel(const models::Model& model, QStringList& definitions, QStringList& preamble) {
  definitions << "EVALUATE_MODEL " + modelFunction(model);
  preamble << modelFile(model);
}

void addModelAlone(const models::Model& model, QStringList& definitions, QStringList& preamble) {
  const ModelUniform parameters = modelUniform(model, "modelParameters");
  definitions << "MODEL_ALONE" << parameters.definition << "MODEL_UNIFORM " + parameters.declaration;
  addModel(model, definitions, preamble);
}

}  // namespace gonio::widgets
