// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/edit_chain.h"

#include <QVector2D>
#include <QVector3D>
#include <algorithm>
#include <glm/vec4.hpp>
#include <vector>

#include "core/math/monotone_cubic.h"
#include "widgets/preview/gl/lobe_stage.h"
#include "widgets/preview/gl/model_uniforms.h"

namespace gonio::widgets {

namespace {

using editing::FactorEdit;
using factorization::PdvFactors;
using factorization::PdvTerm;

constexpr int maxPlaces = 1024;
constexpr int deviationAxis = 1, phiAxis = 2;
using Curve = std::vector<double> PdvTerm::*;
constexpr Curve curvesOfTerm[] = {&PdvTerm::f1, &PdvTerm::f2, &PdvTerm::f3};
using Nodes = std::vector<double> PdvFactors::*;
constexpr Nodes nodesOfAxis[] = {&PdvFactors::thetaNodes, &PdvFactors::deviationNodes, &PdvFactors::phiNodes};

double endOf(const FactorEdit& edit, int axis) {
  const double end =
      std::max((edit.edited.get()->*nodesOfAxis[axis]).back(), (edit.original.get()->*nodesOfAxis[axis]).back());
  return end > 0 ? end : 1;
}

void fillCurve(glm::vec4* texels, int stride, int places, const PdvFactors& f, int term, int axis, double end,
               int axes) {
  const std::vector<double>& nodes = f.*nodesOfAxis[axis];
  for (int channel = 0; channel < 3; ++channel) {
    const PdvTerm& curves = f.channels[std::size_t(channel)][std::size_t(term)];
    const std::vector<double>& values = curves.*curvesOfTerm[axis];
    const std::vector<double> slopes = monotoneSlopes(nodes, values);
    // Without an axis of its own the one value of F3 goes with F1.
    const double factor = axis == 0 && axes == 2 ? curves.f3.front() : 1;
    for (int i = 0; i < places; ++i) {
      const double fraction = i / (places - 1.0);
      const double x = end * (axis == deviationAxis ? fraction * fraction : fraction);
      texels[i * stride][channel] = float(factor * evaluateMonotoneCubic(nodes, values, slopes, x));
    }
  }
}

/// Texels at one place.
int strideOf(const FactorEdit& edit) { return 2 * FactorTexture::termsOf(edit) * FactorTexture::axesOf(edit); }

std::vector<glm::vec4> texelsOf(const FactorEdit& edit, int places) {
  const int axes = FactorTexture::axesOf(edit), stride = strideOf(edit);
  std::vector<glm::vec4> texels(std::size_t(stride) * std::size_t(places), glm::vec4(0));
  const auto fill = [&](const PdvFactors& factors, glm::vec4* first) {
    for (int term = 0; term < factors.terms(); ++term)
      for (int axis = 0; axis < axes; ++axis)
        fillCurve(first + term * axes + axis, stride, places, factors, term, axis, endOf(edit, axis), axes);
  };
  fill(*edit.edited, texels.data());
  // A blend has no other curves than those it shows.
  if (edit.original != edit.edited)
    fill(*edit.original, texels.data() + stride / 2);
  else
    for (auto place = texels.begin(); place != texels.end(); place += stride)
      std::copy_n(place, stride / 2, place + stride / 2);
  return texels;
}

}  // namespace

int FactorTexture::axesOf(const FactorEdit& edit) {
  return edit.edited->phiNodes.size() > 1 || edit.original->phiNodes.size() > 1 ? 3 : 2;
}

int FactorTexture::termsOf(const FactorEdit& edit) { return std::max(edit.edited->terms(), edit.original->terms()); }

bool FactorTexture::sameLayout(const std::vector<FactorEdit>& edits) const {
  return std::equal(edits.begin(), edits.end(), edits_.begin(), edits_.end(),
                    [](const FactorEdit& a, const FactorEdit& b) { return strideOf(a) == strideOf(b); });
}

void FactorTexture::allocate(QOpenGLFunctions_4_1_Core& gl, const std::vector<FactorEdit>& edits) {
  int stride = 0;
  for (const FactorEdit& edit : edits) stride += strideOf(edit);
  GLint maxTexels = 0;
  gl.glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &maxTexels);
  places_ = std::clamp(maxTexels / stride, 2, maxPlaces);
  firstTexels_.clear();
  int texels = 0;
  for (const FactorEdit& edit : edits) {
    firstTexels_.push_back(texels);
    texels += strideOf(edit) * places_;
  }
  gl.glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(std::size_t(texels) * sizeof(glm::vec4)), nullptr, GL_DYNAMIC_DRAW);
  gl.glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer_);
}

void FactorTexture::update(QOpenGLFunctions_4_1_Core& gl, const std::vector<FactorEdit>& edits) {
  if (texture_ == 0) gl.glGenTextures(1, &texture_);
  if (buffer_ == 0) gl.glGenBuffers(1, &buffer_);
  gl.glBindTexture(GL_TEXTURE_BUFFER, texture_);
  gl.glBindBuffer(GL_TEXTURE_BUFFER, buffer_);
  const bool known = sameLayout(edits);
  if (!known) allocate(gl, edits);
  for (std::size_t i = 0; i < edits.size(); ++i) {
    if (known && edits[i].original == edits_[i].original && edits[i].edited == edits_[i].edited) continue;
    const std::vector<glm::vec4> texels = texelsOf(edits[i], places_);
    gl.glBufferSubData(GL_TEXTURE_BUFFER, GLintptr(std::size_t(firstTexels_[i]) * sizeof(glm::vec4)),
                       GLsizeiptr(texels.size() * sizeof(glm::vec4)), texels.data());
  }
  gl.glBindBuffer(GL_TEXTURE_BUFFER, 0);
  edits_ = edits;
}

void FactorTexture::setUniforms(QOpenGLShaderProgram& program, int unit) const {
  program.setUniformValue("factorCurves", unit);
  program.setUniformValue("factorPlaceCount", places_);
  program.setUniformValueArray("factorFirst", firstTexels_.data(), int(firstTexels_.size()));
  std::vector<QVector3D> ends;
  std::vector<QVector2D> limits;
  std::vector<int> transforms;
  for (const FactorEdit& edit : edits_) {
    const auto end = [&](int axis) { return float(endOf(edit, axis)); };
    ends.emplace_back(end(0), end(deviationAxis), end(phiAxis));
    for (const PdvFactors* set : {edit.edited.get(), edit.original.get()}) {
      limits.emplace_back(float(set->lowest), float(set->highest));
      transforms.push_back(int(set->transform));
    }
  }
  program.setUniformValueArray("factorEnds", ends.data(), int(ends.size()));
  program.setUniformValueArray("factorLimits", limits.data(), int(limits.size()));
  program.setUniformValueArray("factorTransform", transforms.data(), int(transforms.size()));
}

void FactorTexture::release(QOpenGLFunctions_4_1_Core& gl) {
  if (texture_) gl.glDeleteTextures(1, &texture_);
  if (buffer_) gl.glDeleteBuffers(1, &buffer_);
  *this = {};
}

namespace {

using editing::DifferentialEdit;
using editing::Edit;
using editing::FactorEdit;

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
    for (const char* state : {"edited", "fitted"})
      uniforms += ' ' + modelUniform(*edit.model, state + QString::number(edits));
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
  definitions << "EDIT_UNIFORMS" + text.uniforms << "EDIT_STAGES" + text.functions << "LAST_STAGE " + text.stage;
  if (text.lobeEdits > 0) definitions << "LOBE_EDITS" << QString("ALBEDO_NODES %1").arg(editing::AlbedoScale::nodes);
  preamble << text.files;
}

void EditChain::bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, const editing::EditList& edits,
                     int unit, const std::shared_ptr<const Brdf>& base) {
  std::vector<FactorEdit> factors;
  if (const auto own = factorization::pdvFactorsOf(*base)) factors.push_back({.original = own, .edited = own});
  if (base != scaledBase_ || edits != scaledEdits_) {
    scales_ = editing::albedoScales(base, edits);
    scaledBase_ = base;
    scaledEdits_ = edits;
  }
  int number = 0;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const Edit& edit = edits[i];
    if (edit.isIdentity()) continue;
    const QString suffix = QString::number(number++);
    program.setUniformValue(("strength" + suffix).toUtf8().constData(), float(edit.strength));
    if (const auto* differential = std::get_if<DifferentialEdit>(&edit.content)) {
      program.setUniformValue(("colours" + suffix).toUtf8().constData(), matrixOf(differential->colours()));
      setModelUniform(program, "edited" + suffix, *differential->model, differential->target());
      setModelUniform(program, "fitted" + suffix, *differential->model, differential->fitted);
      if (differential->composition == editing::Composition::lobes)
        setLobeUniforms(program, suffix, *differential, scales_[i]);
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
