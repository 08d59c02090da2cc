// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/density_mixture.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

/// A sampler for models without a distribution of normals: a diffuse part, and half vectors distributed as the
/// highlight at theta_d = 0. @param diffuseAlbedo of the diffuse part. @param excess callable with theta_h (rad),
/// returns the BRDF value of the highlight without the diffuse part, 1/sr, of any sign.
template <typename Excess>
DensityMixture<CosineDensity, HalfVectorDensity<TabulatedNormals>> excessSampler(double diffuseAlbedo,
                                                                                 const Excess& excess) {
  // d omega_i = 4 cos theta_d d omega_h, and about the mirror direction of a vertical viewer theta_d = theta_h.
  const TabulatedNormals normals(
      [&](double thetaH) { return 4 * std::max(0.0, excess(thetaH)) * std::cos(thetaH) * std::cos(thetaH); });
  return diffuseMixture(diffuseAlbedo, normals.total(), HalfVectorDensity{normals});
}

}  // namespace gonio::models
