// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/coordinates/half_difference_grid.h"
#include "core/math/marginal_warp.h"
#include "core/rendering/environment.h"

namespace gonio::widgets {

/// Message if QOpenGLFunctions_4_1_Core cannot be initialised.
inline constexpr const char* openGlTooOld =
    "the graphics driver does not support OpenGL 4.1 (core profile); update the driver, or start Gonio with the "
    "environment variable LIBGL_ALWAYS_SOFTWARE=1 (software rendering by Mesa)";

/// The texture units of all passes. A pass binds its own; units that two passes share are never bound in one.
enum TextureUnit {
  tableUnit,
  environmentUnit,
  lightPoolUnit,
  lightPoolRadianceUnit,
  accumulationUnit,
  otherAccumulationUnit,
  colourMapUnit,
  factorUnit,
  firstBlendUnit,  ///< and the following ones, one per material
  endOfBlendUnits = firstBlendUnit + 4,
  firstDecoderUnit = endOfBlendUnits,  ///< and the three after it; together 16 units, which every card has
  // The units of the display pass and of the decoder are free while a picture is rendered. An RGL file may occur
  // together with the tables of a blend; its visible normals use the unit of the table.
  rglRowUnit = accumulationUnit,
  rglColourUnit = otherAccumulationUnit,
  rglDistributionUnit = firstDecoderUnit + 2,
  rglAreaUnit = firstDecoderUnit + 3,
  baseNodeUnit = firstBlendUnit,  ///< nodes of a table by angle of incidence, which never occurs with a blend
  // Nothing is decoded while a picture is rendered.
  densityCellUnit = firstDecoderUnit,
  densityRowUnit,
  meshUnit = colourMapUnit,
};

/// Uploads for the preview's shaders. Each function creates the texture if `texture` is 0, else replaces its content.

/// RGBA32F of (rgb * valid, valid): x phi_d (repeats), y theta_d, z theta_h (shaders/preview/table.glsl).
/// @param texels one per cell; without them the content is undefined.
void setTableTexels(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, const HalfDifferenceGrid& grid,
                    const glm::vec4* texels);

/// The same for a table.
/// @param values linear RGB in 1/sr, or transformed; one per cell. @param valid one flag per cell: 1 valid, 0 invalid.
void uploadTable(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, const HalfDifferenceGrid& grid,
                 std::span<const glm::vec3> values, std::span<const std::uint8_t> valid);

/// The texels of an environment, computed on the CPU.
struct EnvironmentTexels {
  static constexpr int poolSide = 256;

  int width = 0, height = 0;
  std::vector<glm::vec4> map;  ///< RGB: radiance; A: density of the sampler, 1/sr
  std::vector<glm::vec4>
      poolDirection;  ///< directions sampled from that density with a low-discrepancy sequence; A: density
  std::vector<glm::vec4> poolRadiance;  ///< radiance in those directions, followed by the blurred environment, row by
                                        ///< row
};

/// Computes the texels, or returns the cached ones while the environment exists. About 10 ms for 512 x 256, up to a
/// second for large pictures, so call it in the background first. Thread-safe.
std::shared_ptr<const EnvironmentTexels> environmentTexels(
    const std::shared_ptr<const rendering::EnvironmentMap>& environment);

/// Uploads three RGBA32F pictures. The blurred environment has no separate texture, because all 16 guaranteed texture
/// units are used.
void uploadEnvironment(QOpenGLFunctions_4_1_Core& gl, GLuint& map, GLuint& poolDirection, GLuint& poolRadiance,
                       const EnvironmentTexels& texels);

/// Uploads a row of `size` display colours, interpolated linearly between texel centres.
void uploadColours(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, int size, const std::vector<glm::vec4>& colours);

/// Dimension `d` (from 0) of point `index` of the additive recurrence of `dimensions` dimensions, in [0, 1):
/// Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences".
double additiveRecurrence(int dimensions, int d, int index);

/// Textures of one context, which must be current when they are destroyed.
class TextureSet {
 public:
  TextureSet() = default;
  TextureSet(const TextureSet&) = delete;
  TextureSet& operator=(const TextureSet&) = delete;
  ~TextureSet();

  /// Binds texture number `index`, created at first use, to a unit.
  void bind(QOpenGLFunctions_4_1_Core& gl, std::size_t index, GLenum target, int unit);

 private:
  std::vector<GLuint> names_;
};

/// Uploads floats to the bound texture, `channels` per texel (1, 2 or 4), with linear filtering, clamped at the
/// borders.
void uploadFloats(QOpenGLFunctions_4_1_Core& gl, int channels, int width, int height, int depth, const float* texels);
void uploadFloats(QOpenGLFunctions_4_1_Core& gl, int channels, int width, int height, const float* texels);

/// Uploads a warp for shaders/preview/marginal_warp.glsl: textures 0 (3D, the cells) and 1 (2D, the rows) of a set.
void uploadWarp(QOpenGLFunctions_4_1_Core& gl, TextureSet& textures, const MarginalWarp& warp, int cellUnit,
                int rowUnit);

}  // namespace gonio::widgets
