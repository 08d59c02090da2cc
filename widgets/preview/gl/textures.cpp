// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/textures.h"

#include <cmath>

namespace gonio::widgets {

namespace {

void bindNew(QOpenGLFunctions_4_1_Core& gl, GLenum target, GLuint& texture) {
  if (texture == 0) gl.glGenTextures(1, &texture);
  gl.glBindTexture(target, texture);
}

void setSampling(QOpenGLFunctions_4_1_Core& gl, GLenum target, GLint filter, GLint wrapS) {
  gl.glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
  gl.glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
  gl.glTexParameteri(target, GL_TEXTURE_WRAP_S, wrapS);
  gl.glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.glTexParameteri(target, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
}

void uploadPicture(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, int width, int height,
                   const std::vector<glm::vec4>& texels, GLint filter) {
  bindNew(gl, GL_TEXTURE_2D, texture);
  gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, texels.data());
  setSampling(gl, GL_TEXTURE_2D, filter, GL_REPEAT);
}

}  // namespace

void setTableTexels(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, const HalfDifferenceGrid& grid,
                    const glm::vec4* texels) {
  bindNew(gl, GL_TEXTURE_3D, texture);
  gl.glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA32F, grid.phiDCount, grid.thetaDCount, grid.thetaHCount, 0, GL_RGBA,
                  GL_FLOAT, texels);
  setSampling(gl, GL_TEXTURE_3D, GL_LINEAR, GL_REPEAT);
}

void uploadTable(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, const HalfDifferenceGrid& grid,
                 std::span<const glm::vec3> values, std::span<const std::uint8_t> valid) {
  std::vector<glm::vec4> texels(values.size());
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = valid[i] ? glm::vec4(values[i], 1) : glm::vec4(0);
  setTableTexels(gl, texture, grid, texels.data());
}

void uploadEnvironment(QOpenGLFunctions_4_1_Core& gl, GLuint& map, GLuint& poolDirection, GLuint& poolRadiance,
                       const EnvironmentTexels& texels) {
  constexpr int side = EnvironmentTexels::poolSide;
  uploadPicture(gl, map, texels.width, texels.height, texels.map, GL_LINEAR);
  uploadPicture(gl, poolDirection, side, side, texels.poolDirection, GL_NEAREST);
  uploadPicture(gl, poolRadiance, side, int(texels.poolRadiance.size()) / side, texels.poolRadiance, GL_NEAREST);
}

void uploadColours(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, int size, const std::vector<glm::vec4>& colours) {
  uploadPicture(gl, texture, size, 1, colours, GL_LINEAR);
  gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
}

double additiveRecurrence(int dimensions, int d, int index) {
  // The root above 1 of x^(dimensions + 1) = x + 1, by its contracting fixed-point iteration.
  double root = 1.5;
  for (int i = 0; i < 60; ++i) root = std::pow(1 + root, 1.0 / (dimensions + 1));
  const double value = 0.5 + std::pow(root, -(d + 1)) * index;
  return value - std::floor(value);
}

}  // namespace gonio::widgets
