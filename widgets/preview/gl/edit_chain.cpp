// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/edit_chain.h"

#include "widgets/preview/gl/lobe_stage.h"
#include "widgets/preview/gl/model_uniforms.h"

namespace gonio::widgets {

namespace {

using editing::DifferentialEdit;
using editing::Edit;
using editing::FactorEdit;

/// The text of a chain while it is put together: functions that each call the one before.
struct ChainText {
  QString uniforms, functions, steps, stage = QStringLiteral("measuredBrdf");
  QStringList definitions, files;
  int edits = 0, factorEdits = 0, stages = 0, lobeEdits = 0;

  QString nextStage() { return QStringLiteral("editStage%1").arg(stages++); }

  /// Ends the steps that look at one pair of directions.
  void endSteps() {
    if (steps.isEmpty()) return;
    const QString name = nextStage();
    functions += QString(" STEPS(%1, %2, %3)").arg(name, stage, steps);
    stage = name;
    steps.clear();
  }

  void add(const DifferentialEdit& edit) {
    if (edit.changesModel()) addModel(edit);
    if (!edit.changesColours()) return;
    uniforms += QString(" uniform mat3 colours%1;").arg(edits);
    steps += QString(" COLOUR_STEP(colours%1, strength%1)").arg(edits);
  }

  void addModel(const DifferentialEdit& edit) {
    for (const char* state : {"edited", "fitted"}) {
      const ModelUniform parameters = modelUniform(*edit.model, state + QString::number(edits));
      uniforms += ' ' + parameters.declaration;
      definitions << parameters.definition;
    }
    files << modelFile(*edit.model);
    if (edit.composition == editing::Composition::lobes) return addLobes(edit);
    const bool additive = edit.composition == editing::Composition::additive;
    steps += QString(" %1_STEP(%2, edited%3, fitted%3, strength%3)")
                 .arg(additive ? "ADDITIVE" : "LOG_PLUS", modelFunction(*edit.model))
                 .arg(edits);
  }

  void addLobes(const DifferentialEdit& edit) {
    endSteps();
    const QString name = nextStage();
    uniforms += lobeUniforms(edit, edits);
    functions += lobeStage(name, stage, edit, edits);
    stage = name;
    ++lobeEdits;
  }

  void add(const FactorEdit& edit) {
    steps += QString(" FACTOR_STEP(%1, %2, %3, %4, strength%5)")
                 .arg(factorEdits++)
                 .arg(FactorTexture::termsOf(edit))
                 .arg(FactorTexture::axesOf(edit))
                 .arg(edit.preserveDetail ? "true" : "false")
                 .arg(edits);
  }

  void add(const Edit& edit) {
    if (edit.isIdentity()) return;
    uniforms += QString(" uniform float strength%1;").arg(edits);
    std::visit([this](const auto& content) { add(content); }, edit.content);
    ++edits;
  }
};

QMatrix3x3 matrixOf(const glm::dmat3& columns) {
  QMatrix3x3 matrix;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) matrix(row, column) = float(columns[column][row]);
  return matrix;
}

}  // namespace

void EditChain::addVariant(const editing::EditList& edits, QStringList& definitions, QStringList& preamble,
                           const factorization::PdvFactors* base) {
  ChainText text;
  if (base) {
    ++text.factorEdits;
    definitions << QString("FACTOR_BASE_TERMS %1").arg(base->terms())
                << QString("FACTOR_BASE_AXES %1").arg(base->phiNodes.size() > 1 ? 3 : 2);
  }
  for (const Edit& edit : edits) text.add(edit);
  if (text.factorEdits > 0) definitions << QString("FACTOR_EDITS %1").arg(text.factorEdits);
  if (text.edits == 0) return;
  text.endSteps();
  definitions << text.definitions << "EDIT_UNIFORMS" + text.uniforms << "EDIT_STAGES" + text.functions
              << "LAST_STAGE " + text.stage;
  if (text.lobeEdits > 0) definitions << "LOBE_EDITS";
  preamble << text.files;
}

void EditChain::bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, const editing::EditList& edits,
                     int unit, const std::shared_ptr<const factorization::PdvFactors>& base) {
  std::vector<FactorEdit> factors;
  if (base) factors.push_back({.original = base, .edited = base});
  int number = 0;
  for (const Edit& edit : edits) {
    if (edit.isIdentity()) continue;
    const QString suffix = QString::number(number++);
    program.setUniformValue(("strength" + suffix).toUtf8().constData(), float(edit.strength));
    if (const auto* differential = std::get_if<DifferentialEdit>(&edit.content)) {
      program.setUniformValue(("colours" + suffix).toUtf8().constData(), matrixOf(differential->colours()));
      setModelUniform(program, "edited" + suffix, *differential->model, differential->target());
      setModelUniform(program, "fitted" + suffix, *differential->model, differential->fitted);
      if (differential->composition == editing::Composition::lobes) setLobeUniforms(program, suffix, *differential);
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
