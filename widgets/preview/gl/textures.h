// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/coordinates/half_difference_grid.h"
#include "core/rendering/environment.h"

namespace gonio::widgets {

/// Uploads for the preview's shaders; each makes the texture when `texture` is 0 and else replaces its content.

/// RGBA32F of (rgb * valid, valid): x phi_d (repeats), y theta_d, z theta_h (shaders/preview/table.glsl).
/// @param texels one per cell; without them the content is undefined.
void setTableTexels(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, const HalfDifferenceGrid& grid,
                    const glm::vec4* texels);

/// The same of a table.
/// @param values linear RGB in 1/sr, or transformed; one per cell, as are the flags (1 valid, 0 invalid).
void uploadTable(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, const HalfDifferenceGrid& grid,
                 std::span<const glm::vec3> values, std::span<const std::uint8_t> valid);

/// What the shaders read of an environment, computed on the CPU.
struct EnvironmentTexels {
  static constexpr int poolSide = 256;

  int width = 0, height = 0;
  std::vector<glm::vec4> map;  ///< radiance and the sampler's density, 1/sr
  std::vector<glm::vec4>
      poolDirection;  ///< drawn from that density by a low-discrepancy sequence, in its order; density
  std::vector<glm::vec4> poolRadiance;  ///< and, in rows below, the blurred environment, row after row
};

/// Computes the texels, or hands out those that are known of an environment that lives. Some 10 ms for 512 x 256, up to
/// a second for large pictures: call it in the background first. From any thread.
std::shared_ptr<const EnvironmentTexels> environmentTexels(const std::shared_ptr<const EnvironmentMap>& environment);

/// Three RGBA32F pictures. The blurred environment has no texture of its own: all 16 that a card must have are used.
void uploadEnvironment(QOpenGLFunctions_4_1_Core& gl, GLuint& map, GLuint& poolDirection, GLuint& poolRadiance,
                       const EnvironmentTexels& texels);

/// A row of `size` display colours, linear between their centres.
void uploadColours(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, int size, const std::vector<glm::vec4>& colours);

/// Dimension `d` (from 0) of point `index` of the additive recurrence of `dimensions` dimensions, in [0, 1):
/// Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences".
double additiveRecurrence(int dimensions, int d, int index);

}  // namespace gonio::widgets
