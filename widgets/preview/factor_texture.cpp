// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/factor_texture.h"

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

constexpr int width = 1024;
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

void fillRow(glm::vec4* row, const PdvFactors& f, int term, int axis, double end, int axes) {
  const std::vector<double>& nodes = f.*nodesOfAxis[axis];
  for (int channel = 0; channel < 3; ++channel) {
    const PdvTerm& curves = f.channels[std::size_t(channel)][std::size_t(term)];
    const std::vector<double>& values = curves.*curvesOfTerm[axis];
    const std::vector<double> slopes = monotoneSlopes(nodes, values);
    // Without an axis of its own the one value of F3 goes with F1.
    const double factor = axis == 0 && axes == 2 ? curves.f3.front() : 1;
    for (int i = 0; i < width; ++i) {
      const double share = i / (width - 1.0);
      const double x = end * (axis == deviationAxis ? share * share : share);
      row[i][channel] = float(factor * evaluateMonotoneCubic(nodes, values, slopes, x));
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
  gl.glBindTexture(GL_TEXTURE_2D, texture_);
  if (known) return;
  original_ = edit.original;
  edited_ = edit.edited;
  const int axes = axesOf(edit), terms = termsOf(edit), height = 2 * terms * axes;
  std::vector<glm::vec4> texels(std::size_t(width) * std::size_t(height), glm::vec4(0));
  const PdvFactors* sets[] = {edited_.get(), original_.get()};
  for (int set = 0; set < 2; ++set)
    for (int term = 0; term < sets[set]->terms(); ++term)
      for (int axis = 0; axis < axes; ++axis)
        fillRow(texels.data() + ((set * terms + term) * axes + axis) * width, *sets[set], term, axis,
                endOf(*edited_, *original_, axis), axes);
  if (height == height_) {
    gl.glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, texels.data());
    return;
  }
  height_ = height;
  gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, texels.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
}

void FactorTexture::setUniforms(QOpenGLShaderProgram& program, int unit) const {
  program.setUniformValue("factorCurves", unit);
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
  *this = {};
}

}  // namespace gonio::widgets
