// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace gonio::plots {

/// Clips a polyline to the rectangle [min, max], for formats without clipping such as SVG 1.2 Tiny; the parts end
/// exactly at the edges. A point that is not finite ends a part. Liang and Barsky 1984, "A New Concept and Method for
/// Line Clipping".
std::vector<std::vector<glm::dvec2>> clipPolyline(std::span<const glm::dvec2> points, const glm::dvec2& min,
                                                  const glm::dvec2& max);

}  // namespace gonio::plots
