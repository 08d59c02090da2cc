// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/fresnel.glsl"
#include "core/models/microfacets.glsl"

// The geometry of the refracted directions, both still in the plane of the facet normal h: i' = (i + s h) / eta with s =
// eta cos theta_d' - cos theta_d, formed without cancellation. eta >= 1, so s >= 0 and both stay above the horizon.
INLINE SurfaceGeometry refractedGeometry(SurfaceGeometry g, REAL eta) {
  REAL contrast = (eta - 1.0) * (eta + 1.0), root = sqrt(contrast + g.cosD * g.cosD);
  REAL s = contrast / (root + g.cosD);
  SurfaceGeometry inside = g;
  inside.wi = (g.wi + s * g.h) / eta;
  inside.wo = (g.wo + s * g.h) / eta;
  inside.cosI = inside.wi.z;
  inside.cosO = inside.wo.z;
  inside.cosD = root / eta;
  return inside;
}

// ks: k_s / 4, kc: k_c / 4. base, coat: 1 / m^2 of the distributions. depth: sigma d.
INLINE vec3 formula_weidlich_wilkie(SurfaceGeometry g, vec3 kd, vec3 ks, REAL base, FresnelTerm baseTerm, vec3 kc,
                                    REAL coat, FresnelTerm coatTerm, REAL eta, vec3 depth) {
  REAL folded = vCavityOverCosines(g), unmasked = folded * g.cosI * g.cosO;
  REAL transmitted = fresnelTransmittance(g.cosD, eta);
  REAL leaving = transmitted * ((1.0 - unmasked) + transmitted * unmasked);
  SurfaceGeometry inside = refractedGeometry(g, eta);
  REAL path = 1.0 / inside.cosI + 1.0 / inside.cosO;
  vec3 absorbed = vec3(exp(-depth.x * path), exp(-depth.y * path), exp(-depth.z * path));
  REAL ofBase = beckmannDistribution(g, base) * fresnel(baseTerm, inside.cosD) * vCavityOverCosines(inside);
  REAL surface = beckmannDistribution(g, coat) * fresnel(coatTerm, g.cosD) * folded;
  return kc * surface + (kd + ks * ofBase) * absorbed * leaving;
}
