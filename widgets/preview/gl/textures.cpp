// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/textures.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <cmath>
#include <map>
#include <mutex>

#include "core/rendering/environment.h"

namespace gonio::widgets {

namespace {

std::shared_ptr<const EnvironmentTexels> compute(const rendering::EnvironmentMap& environment,
                                                 const rendering::EnvironmentMap& blurred) {
  const Image& image = environment.image();
  auto texels = std::make_shared<EnvironmentTexels>();
  texels->width = image.width;
  texels->height = image.height;
  texels->map.resize(image.pixels.size());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Direction centre =
          rendering::EnvironmentMap::directionAt((x + 0.5) / image.width, (y + 0.5) / image.height);
      texels->map[image.index(x, y)] = glm::vec4(image.at(x, y), static_cast<float>(environment.pdf(centre)));
    }
  constexpr int count = EnvironmentTexels::poolSide * EnvironmentTexels::poolSide;
  for (int i = 0; i < count; ++i) {
    const auto sample = environment.sample(additiveRecurrence(2, 0, i), additiveRecurrence(2, 1, i));
    texels->poolDirection.push_back(glm::vec4(glm::vec3(sample.direction), float(sample.pdf)));
    texels->poolRadiance.push_back(glm::vec4(glm::vec3(sample.radiance), 0.f));
  }
  for (const glm::vec3& radiance : blurred.image().pixels) texels->poolRadiance.push_back(glm::vec4(radiance, 0.f));
  return texels;
}

}  // namespace

std::shared_ptr<const EnvironmentTexels> environmentTexels(
    const std::shared_ptr<const rendering::EnvironmentMap>& environment) {
  static std::mutex mutex;
  // Kept as long as the environment lives: it may come back to the preview, and to other windows.
  static std::map<std::weak_ptr<const rendering::EnvironmentMap>, std::shared_ptr<const EnvironmentTexels>,
                  std::owner_less<>>
      known;
  {
    const std::scoped_lock lock(mutex);
    std::erase_if(known, [](const auto& entry) { return entry.first.expired(); });
    if (const auto found = known.find(environment); found != known.end()) return found->second;
  }
  auto texels = compute(*environment, *rendering::blurredEnvironment(environment));
  const std::scoped_lock lock(mutex);
  return known.try_emplace(environment, std::move(texels)).first->second;
}

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
