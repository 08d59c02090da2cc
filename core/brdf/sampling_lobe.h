// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/brdf.h"

namespace gonio {

/// A stand-in density for importance sampling any isotropic BRDF: a cosine-weighted part and the visible normals of a
/// GGX lobe (Heitz 2018, "Sampling the GGX Distribution of Visible Normals"). The preview's shader uses the same two
/// numbers. pdf > 0 over the whole hemisphere, so estimates stay unbiased however bad the fit of the lobe is.
struct SamplingLobe {
  double roughness = 0.3;      ///< GGX alpha, [1e-3, 1]
  double specularShare = 0.5;  ///< fraction of samples taken from the lobe, [0, 0.95]

  /// Samples wi for a viewer wo (z > 0). `u` are three numbers in [0, 1): which part, then two for the direction.
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const;
  /// Density of sample() at wi, 1/sr; 0 below the horizon.
  double pdf(const Direction& wi, const Direction& wo) const;
};

/// Fits the lobe to a BRDF from its values about the mirror direction at a few angles (some ms).
SamplingLobe estimateSamplingLobe(const Brdf& brdf);

/// Whether two draw about as well as each other.
bool areSimilar(const SamplingLobe& a, const SamplingLobe& b);

}  // namespace gonio
