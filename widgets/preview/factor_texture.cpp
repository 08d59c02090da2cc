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

using factorization::PdvFactors;
using factorization::PdvTerm;

constexpr int axisCount = 3;
using Curve = std::vector<double> PdvTerm::*;
constexpr Curve curvesOfTerm[axisCount] = {&PdvTerm::f1, &PdvTerm::f2, &PdvTerm::f3};

const std::vector<double>& nodesOf(const PdvFactors& f, int axis) {
  return axis == 0 ? f.thetaNodes : axis == 1 ? f.deviationNodes : f.phiNodes;
}

int widest(const PdvFactors& f) {
  return int(std::max({f.thetaNodes.size(), f.deviationNodes.size(), f.phiNodes.size()}));
}

/// Rows for values and slopes of each term of each axis; terms that a set does not have are 0.
void appendRows(std::vector<glm::vec4>& texels, const PdvFactors& f, int terms, int width) {
  for (int axis = 0; axis < axisCount; ++axis)
    for (int term = 0; term < terms; ++term) {
      const std::vector<double>& nodes = nodesOf(f, axis);
      const std::size_t row = texels.size();
      texels.resize(row + 2 * std::size_t(width), glm::vec4(0));
      for (std::size_t i = 0; i < nodes.size(); ++i) texels[row + i].a = float(nodes[i]);
      if (term >= f.terms()) continue;
      for (int channel = 0; channel < 3; ++channel) {
        const std::vector<double>& values = f.channels[std::size_t(channel)][std::size_t(term)].*curvesOfTerm[axis];
        const std::vector<double> slopes = monotoneSlopes(nodes, values);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          texels[row + i][channel] = float(values[i]);
          texels[row + std::size_t(width) + i][channel] = float(slopes[i]);
        }
      }
    }
}

}  // namespace

void FactorTexture::update(QOpenGLFunctions_4_1_Core& gl, const editing::FactorEdit& edit) {
  const bool known = texture_ != 0 && edit.original == original_ && edit.edited == edited_;
  if (texture_ == 0) gl.glGenTextures(1, &texture_);
  gl.glBindTexture(GL_TEXTURE_2D, texture_);
  if (known) return;
  original_ = edit.original;
  edited_ = edit.edited;
  terms_ = std::max(edited_->terms(), original_->terms());
  const int width = std::max(widest(*edited_), widest(*original_)), height = 4 * axisCount * terms_;
  std::vector<glm::vec4> texels;
  appendRows(texels, *edited_, terms_, width);
  appendRows(texels, *original_, terms_, width);
  if (width == width_ && height == height_) {
    gl.glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, texels.data());
    return;
  }
  width_ = width;
  height_ = height;
  gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, texels.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
}

void FactorTexture::setUniforms(QOpenGLShaderProgram& program, int unit) const {
  program.setUniformValue("factorCurves", unit);
  program.setUniformValue("factorTerms", terms_);
  const PdvFactors* sets[] = {edited_.get(), original_.get()};
  for (int i = 0; i < 2; ++i) {
    const QByteArray place = '[' + QByteArray::number(i) + ']';
    const PdvFactors& f = *sets[i];
    program.setUniformValue(
        ("factorNodes" + place).constData(),
        QVector3D(float(f.thetaNodes.size()), float(f.deviationNodes.size()), float(f.phiNodes.size())));
    program.setUniformValue(("factorHighest" + place).constData(), float(f.highest));
    program.setUniformValue(("factorTransform" + place).constData(), int(f.transform));
  }
}

void FactorTexture::release(QOpenGLFunctions_4_1_Core& gl) {
  if (texture_) gl.glDeleteTextures(1, &texture_);
  *this = {};
}

}  // namespace gonio::widgets
