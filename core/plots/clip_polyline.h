// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace gonio::plots {

/// The parts of a line through `points` that lie in the rectangle [min, max], each cut exactly at its edges. A point
/// that is not finite ends a part. For formats that cannot clip, such as SVG 1.2 Tiny. Liang and Barsky, "A New Concept
/// and Method for Line Clipping" (1984).
std::vector<std::vector<glm::dvec2>> clipPolyline(std::span<const glm::dvec2> points, const glm::dvec2& min,
                                                  const glm::dvec2& max);

}  // namespace gonio::plots
