// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/warp_textures.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>

namespace gonio::widgets {

namespace {

constexpr GLint internalFormats[] = {0, GL_R32F, GL_RG32F, 0, GL_RGBA32F};
constexpr GLenum formats[] = {0, GL_RED, GL_RG, 0, GL_RGBA};

void setLinear(QOpenGLFunctions_4_1_Core& gl, GLenum target) {
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.glTexParameteri(target, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.glTexParameteri(target, wrap, GL_CLAMP_TO_EDGE);
}

}  // namespace

TextureSet::~TextureSet() {
  if (QOpenGLContext* context = QOpenGLContext::currentContext(); context && !names_.empty())
    context->functions()->glDeleteTextures(GLsizei(names_.size()), names_.data());
}

void TextureSet::bind(QOpenGLFunctions_4_1_Core& gl, std::size_t index, GLenum target, int unit) {
  if (index >= names_.size()) names_.resize(index + 1, 0);
  if (names_[index] == 0) gl.glGenTextures(1, &names_[index]);
  gl.glActiveTexture(GL_TEXTURE0 + GLenum(unit));
  gl.glBindTexture(target, names_[index]);
}

void uploadFloats(QOpenGLFunctions_4_1_Core& gl, int channels, int width, int height, int depth, const float* texels) {
  gl.glTexImage3D(GL_TEXTURE_3D, 0, internalFormats[channels], width, height, depth, 0, formats[channels], GL_FLOAT,
                  texels);
  setLinear(gl, GL_TEXTURE_3D);
}

void uploadFloats(QOpenGLFunctions_4_1_Core& gl, int channels, int width, int height, const float* texels) {
  gl.glTexImage2D(GL_TEXTURE_2D, 0, internalFormats[channels], width, height, 0, formats[channels], GL_FLOAT, texels);
  setLinear(gl, GL_TEXTURE_2D);
}

void uploadWarp(QOpenGLFunctions_4_1_Core& gl, TextureSet& textures, const MarginalWarp& warp, int cellUnit,
                int rowUnit) {
  const SliceStack<float>&density = warp.cellDensity(), &integral = warp.conditional();
  const int width = int(density.width), height = int(density.height);
  const int slices = int(density.values.size()) / (width * height);
  std::vector<float> cells, rows;
  cells.reserve(2 * density.values.size());
  for (std::size_t i = 0; i < density.values.size(); ++i)
    cells.insert(cells.end(), {density.values[i], integral.values[i]});
  for (std::size_t row = 0; row < warp.marginal().size(); ++row)
    rows.insert(rows.end(), {integral.values[(row + 1) * density.width - 1], warp.marginal()[row]});
  textures.bind(gl, 0, GL_TEXTURE_3D, cellUnit);
  uploadFloats(gl, 2, width, height, slices, cells.data());
  textures.bind(gl, 1, GL_TEXTURE_2D, rowUnit);
  uploadFloats(gl, 2, height, slices, rows.data());
}

}  // namespace gonio::widgets
