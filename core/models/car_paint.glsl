// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/fresnel.glsl"
#include "core/models/microfacets.glsl"

// k: k / N of the lobe. sharpness: 1 / m^2.
INLINE vec3 carPaintLobe(SurfaceGeometry g, vec3 k, REAL sharpness, FresnelTerm term) {
  return k * (beckmannDistribution(g, sharpness) * fresnel(term, g.cosD));
}

#ifdef GLSL
// The diffuse term, the coat, the flakes, the haze.
void formula_car_paint(SurfaceGeometry g, vec3 kd, vec3 coat, float coatSharpness, FresnelTerm coatTerm, vec3 flakes,
                       float flakesSharpness, FresnelTerm flakesTerm, vec3 haze, float hazeSharpness,
                       FresnelTerm hazeTerm, out vec3 lobes[4]) {
  float masking = vCavityOverCosines(g);
  lobes[0] = kd;
  lobes[1] = carPaintLobe(g, coat, coatSharpness, coatTerm) * masking;
  lobes[2] = carPaintLobe(g, flakes, flakesSharpness, flakesTerm) * masking;
  lobes[3] = carPaintLobe(g, haze, hazeSharpness, hazeTerm) * masking;
}
#else
INLINE vec3 formula_car_paint(SurfaceGeometry g, vec3 kd, vec3 coat, REAL coatSharpness, FresnelTerm coatTerm,
                              vec3 flakes, REAL flakesSharpness, FresnelTerm flakesTerm, vec3 haze, REAL hazeSharpness,
                              FresnelTerm hazeTerm) {
  vec3 lobes = carPaintLobe(g, coat, coatSharpness, coatTerm) + carPaintLobe(g, flakes, flakesSharpness, flakesTerm) +
               carPaintLobe(g, haze, hazeSharpness, hazeTerm);
  return kd + lobes * vCavityOverCosines(g);
}
#endif
