// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/fresnel.glsl"
#include "core/models/microfacets.glsl"

// ks: k_s / N.
INLINE vec3 formula_cook_torrance(SurfaceGeometry g, vec3 kd, vec3 ks, REAL inverseM2, FresnelTerm term) {
  REAL lobe = beckmannDistribution(g, inverseM2) * fresnel(term, g.cosD) * vCavityOverCosines(g);
  return kd + ks * lobe;
}
