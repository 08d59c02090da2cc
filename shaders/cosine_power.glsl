// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/models/cosine_power.h.
#include "math.glsl"
#include "surface_geometry.glsl"

float powerOfComplement(float x, float n) { return x < 1.0 ? exp(n * logOnePlus(-x)) : 0.0; }

float reflectionPower(vec3 wi, vec3 wo, float n) {
  vec3 apart = vec3(wi.xy + wo.xy, wi.z - wo.z);
  return powerOfComplement(0.5 * dot(apart, apart), n);
}

float halfVectorPower(SurfaceGeometry g, float n) {
  return exp(n * (g.oneMinusCosH < 0.5 ? logOnePlus(-g.oneMinusCosH) : log(g.h.z)));
}

float halfVectorNormalisation(float n) { return (n + 2.0) / (8.0 * pi) * ((n + 4.0) / (n + exp2(-0.5 * n))); }
float reflectionNormalisation(float n) { return (n + 2.0) / (2.0 * pi); }
