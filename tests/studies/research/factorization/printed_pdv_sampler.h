// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/factorization/pdv_brdf.h"

namespace gonio::factorization {

/// PdvSampler's scheme as it is printed (dissertation eq. 4.27-4.32): the azimuth evenly over the whole circle. Samples
/// off the disk are lost (their pdf is 0), so the density integrates to less than 1, at grazing angles to 0.4.
class PrintedPdvSampler {
 public:
  PrintedPdvSampler(const Brdf& brdf, const std::vector<double>& thetaNodes, const std::vector<double>& deviationNodes);

  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const;
  double pdf(const Direction& wi, const Direction& wo) const;

 private:
  DeviationRows rows_;
};

}  // namespace gonio::factorization
