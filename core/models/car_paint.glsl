// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/fresnel.glsl"
#include "core/models/microfacets.glsl"

// k: k / N of the lobe. sharpness: 1 / m^2.
INLINE vec3 carPaintLobe(SurfaceGeometry g, vec3 k, REAL sharpness, FresnelTerm term) {
  return k * (beckmannDistribution(g, sharpness) * fresnel(term, g.cosD));
}

INLINE vec3 formula_car_paint(SurfaceGeometry g, vec3 kd, vec3 coat, REAL coatSharpness, FresnelTerm coatTerm,
                              vec3 flakes, REAL flakesSharpness, FresnelTerm flakesTerm, vec3 haze, REAL hazeSharpness,
                              FresnelTerm hazeTerm) {
  vec3 lobes = carPaintLobe(g, coat, coatSharpness, coatTerm) + carPaintLobe(g, flakes, flakesSharpness, flakesTerm) +
               carPaintLobe(g, haze, hazeSharpness, hazeTerm);
  return kd + lobes * vCavityOverCosines(g);
}
