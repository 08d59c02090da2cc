// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Height-correlated masking, folded so that nothing is divided by a cosine.
INLINE vec3 layeredLobe(SurfaceGeometry g, vec3 normal, vec3 edge, REAL alpha2) {
  REAL slope = g.sin2H + alpha2 * g.h.z * g.h.z;
  REAL rootI = sqrt(alpha2 + (1.0 - alpha2) * g.cosI * g.cosI);
  REAL rootO = sqrt(alpha2 + (1.0 - alpha2) * g.cosO * g.cosO);
  REAL m = 1.0 - g.cosD, m2 = m * m, s = m2 * m2 * m;
  REAL lobe = alpha2 / (pi * slope * slope) * 0.5 / (g.cosO * rootI + g.cosI * rootO);
  return lobe * ((1.0 - s) * normal + s * edge);
}

// The glow of fibres. exponent: 1 / alpha.
INLINE vec3 layeredSheen(SurfaceGeometry g, vec3 strength, REAL exponent) {
  // Sharp rims are large powers of a sine near 1: its logarithm from the cosine keeps the digits.
  REAL logSin2 = g.sin2H > 0.5 ? logOnePlus(-g.h.z * g.h.z) : log(max(g.sin2H, 1e-30));
  REAL distribution = (2.0 + exponent) * exp(0.5 * logSin2 * exponent) / (2.0 * pi);
  return strength * (distribution / (4.0 * (g.cosI + g.cosO - g.cosI * g.cosO)));
}

#ifdef GLSL
vec3 layeredRetro(SurfaceGeometry g, vec3 strength, float alpha2) {
  SurfaceGeometry turned;
  bool lit = surfaceGeometry(g.wi, vec3(-g.wo.xy, g.wo.z), turned);
  return lit ? layeredLobe(turned, strength, strength, alpha2) : vec3(0.0);
}

// The diffuse term, the lobes from wide to sharp (black where they are off), sheen, retroreflection.
void formula_layered(SurfaceGeometry g, vec3 kd, vec3 baseNormal, vec3 baseEdge, float base, vec3 flakesNormal,
                     vec3 flakesEdge, float flakes, vec3 coatNormal, vec3 coatEdge, float coat, vec3 sheen,
                     float sheenExponent, vec3 retro, float retroAlpha2, float sheenIsOn, float retroIsOn,
                     out vec3 lobes[6]) {
  lobes[0] = kd;
  lobes[1] = layeredLobe(g, baseNormal, baseEdge, base);
  lobes[2] = layeredLobe(g, flakesNormal, flakesEdge, flakes);
  lobes[3] = layeredLobe(g, coatNormal, coatEdge, coat);
  // Loops of at most one turn: software OpenGL runs the body of an `if` whether it is true or not.
  lobes[4] = lobes[5] = vec3(0.0);
  for (int turn = 0; turn < int(sheenIsOn + 0.5); ++turn) lobes[4] = layeredSheen(g, sheen, sheenExponent);
  for (int turn = 0; turn < int(retroIsOn + 0.5); ++turn) lobes[5] = layeredRetro(g, retro, retroAlpha2);
}
#endif
