// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, C_xy, C_z, exponent, normalisation (0 ngan, 1 none)
#include "cosine_power.glsl"

const int PARAMETER_COUNT_LAFORTUNE = 6;

vec3 evaluate_lafortune(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_LAFORTUNE]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float n = p[4].x, xy = p[2].x, z = p[3].x;
  float largest = max(abs(xy), z);
  if (!(largest > 1e-12)) return p[0] / pi;
  float a = abs(xy) / largest, b = z / largest, dz = wi.z - wo.z;
  vec2 apart = wi.xy + (xy > 0.0 ? -wo.xy : wo.xy);
  float lean = a > b ? (a - b) * (wi.z * wi.z + wo.z * wo.z) : (b - a) * (dot(wi.xy, wi.xy) + dot(wo.xy, wo.xy));
  float lobe = powerOfComplement(0.5 * (a * dot(apart, apart) + b * dz * dz + lean), n);
  return p[0] / pi + p[1] * (lobe * (p[5].x < 0.5 ? reflectionNormalisation(n) : exp(n * log(largest))));
}
