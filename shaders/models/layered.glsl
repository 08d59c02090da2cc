// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse; of each of three lobes reflectance, edge, roughness; sheen and its roughness, retroreflection and its
// roughness; whether the flakes, the coat, the sheen and the retroreflection are on
#include "math.glsl"
#include "surface_geometry.glsl"

const int PARAMETER_COUNT_LAYERED = 18;

vec3 layeredLobe(SurfaceGeometry g, vec3 normal, vec3 edge, float alpha) {
  float alpha2 = alpha * alpha;
  float slope = g.sin2H + alpha2 * g.h.z * g.h.z;
  float rootI = sqrt(alpha2 + (1.0 - alpha2) * g.cosI * g.cosI);
  float rootO = sqrt(alpha2 + (1.0 - alpha2) * g.cosO * g.cosO);
  float m = 1.0 - g.cosD, m2 = m * m, s = m2 * m2 * m;
  return (0.5 * alpha2 / (pi * slope * slope * (g.cosO * rootI + g.cosI * rootO))) * mix(normal, edge, s);
}

vec3 layeredSheen(SurfaceGeometry g, vec3 strength, float alpha) {
  // Sharp rims are large powers of a sine near 1: its logarithm from the cosine keeps the digits.
  float logSin2 = g.sin2H > 0.5 ? logOnePlus(-g.h.z * g.h.z) : log(max(g.sin2H, 1e-30));
  float distribution = (2.0 + 1.0 / alpha) * exp(logSin2 * 0.5 / alpha) / (2.0 * pi);
  return strength * (distribution / (4.0 * (g.cosI + g.cosO - g.cosI * g.cosO)));
}

vec3 layeredRetro(vec3 wi, vec3 wo, vec3 strength, float alpha) {
  SurfaceGeometry g;
  return surfaceGeometry(wi, vec3(-wo.xy, wo.z), g) ? layeredLobe(g, strength, strength, alpha) : vec3(0.0);
}

// The terms of the sum: the diffuse term, the lobes from wide to sharp, sheen, retroreflection.
const int LOBE_COUNT_LAYERED = 6;
void lobes_layered(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_LAYERED], out vec3 lobes[LOBE_COUNT_LAYERED]) {
  SurfaceGeometry g;
  bool lit = surfaceGeometry(wi, wo, g);
  lobes[0] = lit ? p[0] / pi : vec3(0.0);
  lobes[1] = lit ? layeredLobe(g, p[1], p[2], p[3].x) : vec3(0.0);
  lobes[2] = lit && p[14].x > 0.5 ? layeredLobe(g, p[4], p[5], p[6].x) : vec3(0.0);
  lobes[3] = lit && p[15].x > 0.5 ? layeredLobe(g, p[7], p[8], p[9].x) : vec3(0.0);
  // Loops of at most one turn: software OpenGL runs the body of an `if` whether it is true or not.
  lobes[4] = lobes[5] = vec3(0.0);
  for (int turn = 0; turn < int(p[16].x + 0.5); ++turn) lobes[4] = lit ? layeredSheen(g, p[10], p[11].x) : vec3(0.0);
  for (int turn = 0; turn < int(p[17].x + 0.5); ++turn)
    lobes[5] = lit ? layeredRetro(wi, wo, p[12], p[13].x) : vec3(0.0);
}

vec3 evaluate_layered(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_LAYERED]) {
  vec3 lobes[LOBE_COUNT_LAYERED];
  lobes_layered(wi, wo, p, lobes);
  return lobes[0] + lobes[1] + lobes[2] + lobes[3] + lobes[4] + lobes[5];
}
