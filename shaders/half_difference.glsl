// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/coordinates/half_difference.h: (theta_h, theta_d, phi_d) of two directions in the local frame, rad.
// phi_d lies in (-pi, pi].
#include "math.glsl"

// Returns false when wi = -wo.
bool toHalfDifference(vec3 wi, vec3 wo, out vec3 coordinates) {
  vec3 sum = wi + wo;
  vec3 difference = wi - wo;
  float sumLength = length(sum);
  coordinates = vec3(0.0);
  if (sumLength < 1e-6) return false;
  vec3 h = sum / sumLength;
  float differenceLength = length(difference);
  float r = length(h.xy);
  coordinates.x = atan(r, h.z);
  coordinates.y = atan(differenceLength, sumLength);
  if (differenceLength < 1e-6) return true;
  vec3 tangent = vec3(1.0, 0.0, 0.0);
  vec3 bitangent = vec3(0.0, 1.0, 0.0);
  if (r > 1e-6) {
    tangent = vec3(h.z * h.x / r, h.z * h.y / r, -r);
    bitangent = vec3(-h.y / r, h.x / r, 0.0);
  }
  coordinates.z = atan(dot(difference, bitangent), dot(difference, tangent));
  return true;
}
