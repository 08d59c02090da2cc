// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/brdf.h"

namespace gonio {

/// An approximate density for importance sampling of any isotropic BRDF: a cosine-weighted part and the visible normals
/// of a GGX lobe (Heitz 2018, "Sampling the GGX Distribution of Visible Normals"). The preview's shader uses the same
/// two parameters. pdf > 0 over the whole hemisphere, so estimates are unbiased even if the lobe fits badly.
struct SamplingLobe {
  double roughness = 0.3;         ///< GGX alpha, [1e-3, 1]
  double specularFraction = 0.5;  ///< fraction of samples taken from the lobe, [0, 0.95]

  /// Samples wi for a viewer wo (z > 0). `u` in [0, 1)^3: u.x selects the part, u.y and u.z the direction.
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const;
  /// Density of sample() at wi, 1/sr; 0 below the horizon.
  double pdf(const Direction& wi, const Direction& wo) const;
};

/// Fits the lobe to a BRDF: minimises the second moment of the estimator at isotropicMomentProbes(). Takes a few ms.
SamplingLobe estimateSamplingLobe(const Brdf& brdf);

/// Whether two lobes sample about equally well.
bool areSimilar(const SamplingLobe& a, const SamplingLobe& b);

}  // namespace gonio
