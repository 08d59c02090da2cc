// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/edit_chain.h"

namespace gonio::widgets {

namespace {

using editing::DifferentialEdit;
using editing::Edit;
using editing::FactorEdit;

QString modelId(const models::Model& model) {
  return QString::fromUtf8(model.spec().id.data(), qsizetype(model.spec().id.size()));
}

/// The text of a chain while it is put together.
struct ChainText {
  QString uniforms, steps;
  QStringList files;
  int edits = 0, factorEdits = 0;

  void add(const DifferentialEdit& edit) {
    const auto count = edit.model->shaderParameters(edit.edited).size();
    uniforms += QString(" uniform vec3 edited%1[%2], fitted%1[%2];").arg(edits).arg(count);
    steps += QString(" MODEL_STEP(%1, edited%2, fitted%2, strength%2)").arg(modelFunction(*edit.model)).arg(edits);
    files << modelFile(*edit.model);
  }

  void add(const FactorEdit& edit) {
    steps += QString(" FACTOR_STEP(%1, %2, %3, %4, strength%5)")
                 .arg(factorEdits++)
                 .arg(FactorTexture::termsOf(edit))
                 .arg(FactorTexture::axesOf(edit))
                 .arg(edit.keepDetail ? "true" : "false")
                 .arg(edits);
  }

  void add(const Edit& edit) {
    if (edit.isIdentity()) return;
    uniforms += QString(" uniform float strength%1;").arg(edits);
    std::visit([this](const auto& content) { add(content); }, edit.content);
    ++edits;
  }
};

}  // namespace

QString modelFunction(const models::Model& model) { return "evaluate_" + modelId(model).replace('-', '_'); }

QString modelFile(const models::Model& model) { return "models/" + modelId(model) + ".glsl"; }

void setModelParameters(QOpenGLShaderProgram& program, const QString& name, const models::Model& model,
                        const models::ParameterValues& values) {
  const std::vector<glm::vec3> uniforms = model.shaderParameters(values);
  program.setUniformValueArray(name.toUtf8().constData(), &uniforms.front().x, int(uniforms.size()), 3);
}

void EditChain::addVariant(const editing::EditList& edits, QStringList& definitions, QStringList& preamble) {
  ChainText text;
  for (const Edit& edit : edits) text.add(edit);
  if (text.edits == 0) return;
  definitions << "EDIT_UNIFORMS" + text.uniforms << "EDIT_STEPS" + text.steps;
  if (text.factorEdits > 0) definitions << QString("FACTOR_EDITS %1").arg(text.factorEdits);
  preamble << text.files;
}

void EditChain::bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, const editing::EditList& edits,
                     int unit) {
  std::vector<FactorEdit> factors;
  int number = 0;
  for (const Edit& edit : edits) {
    if (edit.isIdentity()) continue;
    const QString suffix = QString::number(number++);
    program.setUniformValue(("strength" + suffix).toUtf8().constData(), float(edit.strength));
    if (const auto* differential = std::get_if<DifferentialEdit>(&edit.content)) {
      setModelParameters(program, "edited" + suffix, *differential->model, differential->edited);
      setModelParameters(program, "fitted" + suffix, *differential->model, differential->fitted);
    } else {
      factors.push_back(std::get<FactorEdit>(edit.content));
    }
  }
  if (factors.empty()) return;
  gl.glActiveTexture(GL_TEXTURE0 + GLenum(unit));
  factors_.update(gl, factors);
  factors_.setUniforms(program, unit);
}

}  // namespace gonio::widgets
