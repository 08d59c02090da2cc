// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/studies/research/factorization/printed_pdv_sampler.h"

#include <cmath>

#include "core/coordinates/projected_deviation.h"
#include "core/math/types.h"

namespace gonio::factorization {

PrintedPdvSampler::PrintedPdvSampler(const Brdf& brdf, const std::vector<double>& thetaNodes,
                                     const std::vector<double>& deviationNodes)
    : rows_(brdf, thetaNodes, deviationNodes, DeviationRows::Ring::whole) {}

DirectionSample PrintedPdvSampler::sample(const Direction& wo, const glm::dvec3& u) const {
  const double sine = std::hypot(wo.x, wo.y), thetaR = std::atan2(sine, wo.z);
  const std::size_t bin = rows_.sampleBin(thetaR, u.x);
  const double low = rows_.low(bin), high = rows_.high(bin, sine);
  const double deviation = std::sqrt(low * low + u.y * (high - low) * (high + low));
  const ProjectedDirections at = fromProjectedDeviation({thetaR, deviation, 2 * pi * u.z});
  if (!at.valid) return {};
  const Direction wi = AzimuthRotation(std::atan2(wo.y, wo.x))(at.pair.wi);
  return {wi, pdf(wi, wo)};
}

double PrintedPdvSampler::pdf(const Direction& wi, const Direction& wo) const {
  if (!(wi.z > 0) || !(wo.z >= 0)) return 0;
  const double sine = std::hypot(wo.x, wo.y);
  const std::size_t bin = rows_.binOf(std::hypot(wi.x + wo.x, wi.y + wo.y));
  if (bin >= rows_.bins()) return 0;
  const double low = rows_.low(bin), high = rows_.high(bin, sine);
  if (!(high > low)) return 0;
  return rows_.probability(std::atan2(sine, wo.z), bin) * wi.z / ((high - low) * (high + low) * pi);
}

}  // namespace gonio::factorization
