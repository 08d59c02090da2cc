// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/factor_texture.h"

#include <QVector3D>
#include <algorithm>
#include <glm/vec4.hpp>
#include <vector>

#include "core/math/monotone_cubic.h"

namespace gonio::widgets {

namespace {

using editing::FactorEdit;
using factorization::PdvFactors;
using factorization::PdvTerm;

constexpr int mostPlaces = 1024;
constexpr int deviationAxis = 1, phiAxis = 2;
using Curve = std::vector<double> PdvTerm::*;
constexpr Curve curvesOfTerm[] = {&PdvTerm::f1, &PdvTerm::f2, &PdvTerm::f3};
using Nodes = std::vector<double> PdvFactors::*;
constexpr Nodes nodesOfAxis[] = {&PdvFactors::thetaNodes, &PdvFactors::deviationNodes, &PdvFactors::phiNodes};

int axesOf(const FactorEdit& edit) {
  return edit.edited->phiNodes.size() > 1 || edit.original->phiNodes.size() > 1 ? 3 : 2;
}
int termsOf(const FactorEdit& edit) { return std::max(edit.edited->terms(), edit.original->terms()); }

double endOf(const PdvFactors& a, const PdvFactors& b, int axis) {
  const double end = std::max((a.*nodesOfAxis[axis]).back(), (b.*nodesOfAxis[axis]).back());
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
      const double share = i / (places - 1.0);
      const double x = end * (axis == deviationAxis ? share * share : share);
      texels[i * stride][channel] = float(factor * evaluateMonotoneCubic(nodes, values, slopes, x));
    }
  }
}

}  // namespace

QStringList FactorTexture::definitions(const FactorEdit& edit) {
  QStringList definitions{"EDIT_FACTORS", QString("FACTOR_AXES %1").arg(axesOf(edit)),
                          QString("FACTOR_TERMS %1").arg(termsOf(edit))};
  if (edit.keepDetail) definitions << "KEEP_DETAIL";
  return definitions;
}

void FactorTexture::update(QOpenGLFunctions_4_1_Core& gl, const FactorEdit& edit) {
  const bool known = texture_ != 0 && edit.original == original_ && edit.edited == edited_;
  if (texture_ == 0) gl.glGenTextures(1, &texture_);
  gl.glBindTexture(GL_TEXTURE_BUFFER, texture_);
  if (known) return;
  original_ = edit.original;
  edited_ = edit.edited;
  const int axes = axesOf(edit), terms = termsOf(edit), stride = 2 * terms * axes;
  GLint mostTexels = 0;
  gl.glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &mostTexels);
  places_ = std::clamp(mostTexels / stride, 2, mostPlaces);
  std::vector<glm::vec4> texels(std::size_t(stride) * std::size_t(places_), glm::vec4(0));
  const auto fill = [&](const PdvFactors& factors, glm::vec4* first) {
    for (int term = 0; term < factors.terms(); ++term)
      for (int axis = 0; axis < axes; ++axis)
        fillCurve(first + term * axes + axis, stride, places_, factors, term, axis, endOf(*edited_, *original_, axis),
                  axes);
  };
  fill(*edited_, texels.data());
  // A blend has no other curves than those it shows.
  if (original_ != edited_)
    fill(*original_, texels.data() + terms * axes);
  else
    for (auto place = texels.begin(); place != texels.end(); place += stride)
      std::copy_n(place, terms * axes, place + terms * axes);
  if (buffer_ == 0) gl.glGenBuffers(1, &buffer_);
  gl.glBindBuffer(GL_TEXTURE_BUFFER, buffer_);
  gl.glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(texels.size() * sizeof(glm::vec4)), texels.data(), GL_DYNAMIC_DRAW);
  gl.glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer_);
  gl.glBindBuffer(GL_TEXTURE_BUFFER, 0);
}

void FactorTexture::setUniforms(QOpenGLShaderProgram& program, int unit) const {
  program.setUniformValue("factorCurves", unit);
  program.setUniformValue("factorPlaceCount", places_);
  const auto end = [this](int axis) { return float(endOf(*edited_, *original_, axis)); };
  program.setUniformValue("factorEnds", QVector3D(end(0), end(deviationAxis), end(phiAxis)));
  const PdvFactors* sets[] = {edited_.get(), original_.get()};
  for (int i = 0; i < 2; ++i) {
    const QByteArray place = '[' + QByteArray::number(i) + ']';
    program.setUniformValue(("factorHighest" + place).constData(), float(sets[i]->highest));
    program.setUniformValue(("factorTransform" + place).constData(), int(sets[i]->transform));
  }
}

void FactorTexture::release(QOpenGLFunctions_4_1_Core& gl) {
  if (texture_) gl.glDeleteTextures(1, &texture_);
  if (buffer_) gl.glDeleteBuffers(1, &buffer_);
  *this = {};
}

}  // namespace gonio::widgets
