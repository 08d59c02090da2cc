// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/textures.h"

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

void uploadTable(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, const TabulatedBrdf& table) {
  std::vector<glm::vec4> texels(table.values().size());
  // Invalid cells hold 0 already: their alpha alone must be 0.
  for (std::size_t i = 0; i < texels.size(); ++i)
    texels[i] = glm::vec4(table.values()[i], table.valid()[i] ? 1.f : 0.f);
  const HalfDifferenceGrid& grid = table.grid();
  bindNew(gl, GL_TEXTURE_3D, texture);
  gl.glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA32F, grid.phiDCount, grid.thetaDCount, grid.thetaHCount, 0, GL_RGBA,
                  GL_FLOAT, texels.data());
  setSampling(gl, GL_TEXTURE_3D, GL_LINEAR, GL_REPEAT);
}

void uploadEnvironmentMap(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, const EnvironmentMap& environment) {
  const Image& image = environment.image();
  std::vector<glm::vec4> texels(image.pixels.size());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Direction centre = EnvironmentMap::directionAt((x + 0.5) / image.width, (y + 0.5) / image.height);
      texels[image.index(x, y)] = glm::vec4(image.at(x, y), static_cast<float>(environment.pdf(centre)));
    }
  uploadPicture(gl, texture, image.width, image.height, texels, GL_LINEAR);
}

void uploadLightPool(QOpenGLFunctions_4_1_Core& gl, GLuint& directions, GLuint& radiance,
                     const EnvironmentMap& environment) {
  constexpr int side = 256;
  std::vector<glm::vec4> drawn(side * side), seen(side * side);
  for (int i = 0; i < side * side; ++i) {
    const auto sample = environment.sample(additiveRecurrence(2, 0, i), additiveRecurrence(2, 1, i));
    drawn[std::size_t(i)] = glm::vec4(glm::vec3(sample.direction), float(sample.pdf));
    seen[std::size_t(i)] = glm::vec4(glm::vec3(sample.radiance), 0.f);
  }
  uploadPicture(gl, directions, side, side, drawn, GL_NEAREST);
  uploadPicture(gl, radiance, side, side, seen, GL_NEAREST);
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
