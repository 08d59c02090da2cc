// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Twins of the functions of core/sampling/half_vector_densities.h; x runs along the grain.
#include "math.glsl"

float ggxDensity(vec3 h, vec2 alpha) {
  float area = alpha.x * alpha.y;
  float slope = h.x * h.x * (alpha.y / alpha.x) + h.y * h.y * (alpha.x / alpha.y) + area * h.z * h.z;
  return area / (pi * slope * slope);
}
float ggxCosineOverG1(vec3 w, vec2 alpha) { return 0.5 * (w.z + length(vec3(alpha * w.xy, w.z))); }
