// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/edit_chain.h"

#include <algorithm>

#include "core/editing/lobe_change.h"

namespace gonio::widgets {

namespace {

using editing::DifferentialEdit;
using editing::Edit;
using editing::FactorEdit;

/// "ggx".
QString modelId(const models::Model& model) {
  return QString::fromUtf8(model.spec().id.data(), qsizetype(model.spec().id.size()));
}

/// A function for an edit that is composed by lobes: twin of editing::LobeChange. %1 its name, %2 the stage before it,
/// %3 the model's name in the shader, %4 that in upper case, %5 the number of the edit. Lobes that widen alike share a
/// look-up of the base, in a loop over the widths that there are: software OpenGL runs the body of an `if` whether it
/// is true or not.
constexpr const char* lobesStage = R"(
vec3 %1(vec3 wi, vec3 wo, out bool valid) {
  vec3 value = %2(wi, wo, valid);
  if (!valid || wi.z <= 0.0 || wo.z <= 0.0) return value;
  vec3 before[LOBE_COUNT_%4], after[LOBE_COUNT_%4];
  lobes_%3(wi, wo, fitted%5, before);
  lobes_%3(wi, wo, edited%5, after);
  vec3 model = vec3(0.0);
  for (int part = 0; part < LOBE_COUNT_%4; ++part) model += before[part];
  vec3 ratio = fitRatio(value, model);
  vec3 change = vec3(0.0);
  for (int part = 0; part < LOBE_COUNT_%4; ++part) {
    vec3 own = scales%5[part] < 0.0 ? bodyRatio(ratio, before[part], model) : ratio;
    if (scales%5[part] != 0.0) change -= before[part] * own;
    if (abs(scales%5[part]) == 1.0) change += after[part] * recolouredRatio(own, before[part], after[part]);
  }
  for (int turn = 0; turn < warps%5; ++turn) {
    vec3 movedIn = wi, movedOut = wo;
    bool measured;
    scaleHalfTangent(movedIn, movedOut, warpScales%5[turn]);
    vec3 there = %2(movedIn, movedOut, measured);
    vec3 carried = measured ? fitRatio(there, evaluate_%3(movedIn, movedOut, fitted%5)) : ratio;
    for (int part = 0; part < LOBE_COUNT_%4; ++part)
      if (scales%5[part] == warpScales%5[turn]) change += after[part] * recolouredRatio(carried, before[part], after[part]);
  }
  return withChange(value, strength%5 * change);
})";

/// The text of a chain while it is put together: functions that each call the one before.
struct ChainText {
  QString uniforms, functions, steps, stage = QStringLiteral("measuredBrdf");
  QStringList files;
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
    const auto count = edit.model->shaderParameters(edit.fitted).size();
    uniforms += QString(" uniform vec3 edited%1[%2], fitted%1[%2];").arg(edits).arg(count);
    files << modelFile(*edit.model);
    if (edit.composition == editing::Composition::lobes) return addLobes(edit);
    const bool additive = edit.composition == editing::Composition::additive;
    steps += QString(" %1_STEP(%2, edited%3, fitted%3, strength%3)")
                 .arg(additive ? "ADDITIVE" : "LOG_PLUS", modelFunction(*edit.model))
                 .arg(edits);
  }

  void addLobes(const DifferentialEdit& edit) {
    endSteps();
    const QString model = modelId(*edit.model).replace('-', '_'), name = nextStage();
    uniforms += QString(" uniform float scales%1[%2], warpScales%1[%2]; uniform int warps%1;")
                    .arg(edits)
                    .arg(edit.model->lobes(edit.fitted).size());
    functions += QString(lobesStage).arg(name, stage, model, model.toUpper()).arg(edits).replace('\n', ' ');
    stage = name;
    ++lobeEdits;
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

/// Of each part of the model what LobeChange scales by, 0 where it does not change; and those at which the base is
/// looked up once more.
void setScales(QOpenGLShaderProgram& program, const QString& suffix, const DifferentialEdit& edit) {
  std::vector<float> scales, warps;
  for (const double scale : editing::lobeScales(edit)) {
    scales.push_back(float(scale));
    const bool isKnown = std::ranges::find(warps, scales.back()) != warps.end();
    if (scale > 0 && scale != 1 && !isKnown) warps.push_back(scales.back());
  }
  program.setUniformValue(("warps" + suffix).toUtf8().constData(), int(warps.size()));
  warps.resize(scales.size());
  program.setUniformValueArray(("scales" + suffix).toUtf8().constData(), scales.data(), int(scales.size()), 1);
  program.setUniformValueArray(("warpScales" + suffix).toUtf8().constData(), warps.data(), int(warps.size()), 1);
}

QMatrix3x3 matrixOf(const glm::dmat3& columns) {
  QMatrix3x3 matrix;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) matrix(row, column) = float(columns[column][row]);
  return matrix;
}

}  // namespace

QString modelFunction(const models::Model& model) { return "evaluate_" + modelId(model).replace('-', '_'); }

QString modelFile(const models::Model& model) { return "models/" + modelId(model) + ".glsl"; }

void setModelParameters(QOpenGLShaderProgram& program, const QString& name, const models::Model& model,
                        const models::ParameterValues& values) {
  const std::vector<glm::vec3> uniforms = model.shaderParameters(values);
  program.setUniformValueArray(name.toUtf8().constData(), &uniforms.front().x, int(uniforms.size()), 3);
}

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
  definitions << "EDIT_UNIFORMS" + text.uniforms << "EDIT_STAGES" + text.functions << "LAST_STAGE " + text.stage;
  if (text.lobeEdits > 0) definitions << "LOBE_EDITS";
  preamble << text.files;
}

void EditChain::bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, const editing::EditList& edits,
                     int unit, std::shared_ptr<const factorization::PdvFactors> base) {
  std::vector<FactorEdit> factors;
  if (base) factors.push_back({.original = base, .edited = base});
  int number = 0;
  for (const Edit& edit : edits) {
    if (edit.isIdentity()) continue;
    const QString suffix = QString::number(number++);
    program.setUniformValue(("strength" + suffix).toUtf8().constData(), float(edit.strength));
    if (const auto* differential = std::get_if<DifferentialEdit>(&edit.content)) {
      program.setUniformValue(("colours" + suffix).toUtf8().constData(), matrixOf(differential->colours()));
      setModelParameters(program, "edited" + suffix, *differential->model, differential->target());
      setModelParameters(program, "fitted" + suffix, *differential->model, differential->fitted);
      if (differential->composition == editing::Composition::lobes) setScales(program, suffix, *differential);
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
