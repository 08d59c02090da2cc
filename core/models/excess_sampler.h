// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/half_vector_lobe.h"
#include "core/brdf/lobe_mixture.h"
#include "core/brdf/tabulated_normals.h"

namespace gonio::models {

/// A sampler for models that are given by their values rather than by a distribution of normals: a matte part, and half
/// vectors by what the highlight adds to it at theta_d = 0.
/// @param diffuseAlbedo of the matte part; @param excess what the highlight adds at theta_h (rad), 1/sr, any sign.
template <typename Excess>
LobeMixture<CosineLobe, HalfVectorLobe<TabulatedNormals>> excessSampler(double diffuseAlbedo, const Excess& excess) {
  // d omega_i = 4 cos theta_d d omega_h, and about the mirror direction of a vertical viewer theta_d = theta_h.
  const TabulatedNormals normals(
      [&](double thetaH) { return 4 * std::max(0.0, excess(thetaH)) * std::cos(thetaH) * std::cos(thetaH); });
  return diffuseAnd(diffuseAlbedo, normals.total(), HalfVectorLobe{normals});
}

}  // namespace gonio::models
