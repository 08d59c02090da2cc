// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, exponent
#include "cosine_power.glsl"

const int PARAMETER_COUNT_EDWARDS_DISK = 3;

// Twin of core/sampling/direction_densities.h.
float squaredRimFraction(vec2 deviation, vec3 wo) {
  float squared = dot(deviation, deviation), along = dot(deviation, wo.xy);
  if (!(squared > 0.0)) return 0.0;
  float root = sqrt(along * along + wo.z * wo.z * squared);
  float fraction = along > 0.0 ? squared / (along + root) : (root - along) / (wo.z * wo.z);
  return min(1.0, fraction * fraction);
}

vec3 evaluate_edwards_disk(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_EDWARDS_DISK]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float lobe = powerOfComplement(squaredRimFraction(wi.xy + wo.xy, wo), p[2].x);
  return p[0] / pi + p[1] * (lobe * (p[2].x + 1.0) / pi);
}
