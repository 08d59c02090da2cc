// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <glm/vec4.hpp>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/rendering/environment.h"

namespace gonio::widgets {

/// Uploads for the preview's shaders; each makes the texture when `texture` is 0 and else replaces its content.

/// RGBA32F of (rgb * valid, valid): x phi_d (repeats), y theta_d, z theta_h (shaders/preview/table.glsl).
void uploadTable(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, const TabulatedBrdf& table);

/// RGBA32F of radiance and the sampler's density, 1/sr.
void uploadEnvironmentMap(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, const EnvironmentMap& environment);

/// 256 x 256 directions drawn from the environment's density by a low-discrepancy sequence, in its order: direction and
/// density (1/sr) in the first texture, radiance in the second.
void uploadLightPool(QOpenGLFunctions_4_1_Core& gl, GLuint& directions, GLuint& radiance,
                     const EnvironmentMap& environment);

/// A row of `size` display colours, linear between their centres.
void uploadColours(QOpenGLFunctions_4_1_Core& gl, GLuint& texture, int size, const std::vector<glm::vec4>& colours);

/// Dimension `d` (from 0) of point `index` of the additive recurrence of `dimensions` dimensions, in [0, 1):
/// Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences".
double additiveRecurrence(int dimensions, int d, int index);

}  // namespace gonio::widgets
