// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/fresnel.glsl"
#include "core/models/microfacets.glsl"

// ks: k_s K / 4.
INLINE vec3 formula_torrance_sparrow(SurfaceGeometry g, vec3 kd, vec3 ks, REAL inverseM2, FresnelTerm term) {
  REAL thetaH = acuteAngle(sqrt(g.sin2H), g.h.z);
  REAL lobe = exp(-thetaH * thetaH * inverseM2) * fresnel(term, g.cosD) * vCavityOverCosines(g);
  return kd + ks * lobe;
}
