// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/cosine_power.glsl"

#ifdef GLSL
// Twin of core/sampling/direction_densities.h.
float squaredRimFraction(vec2 deviation, vec3 wo) {
  float squared = dot(deviation, deviation), along = dot(deviation, wo.xy);
  if (!(squared > 0.0)) return 0.0;
  float root = sqrt(along * along + wo.z * wo.z * squared);
  float fraction = along > 0.0 ? squared / (along + root) : (root - along) / (wo.z * wo.z);
  return min(1.0, fraction * fraction);
}
#endif

// ks: k_s (n + 1) / pi.
INLINE vec3 formula_edwards_disk(SurfaceGeometry g, vec3 kd, vec3 ks, REAL n) {
  vec2 deviation = vec2(g.wi.x + g.wo.x, g.wi.y + g.wo.y);
  return kd + ks * powerOfComplement(squaredRimFraction(deviation, g.wo), n);
}
