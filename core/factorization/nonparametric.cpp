// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/nonparametric.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/pairwise_brdf.h"
#include "core/factorization/nonparametric_interval.h"

namespace gonio::factorization {

namespace {

double between(const std::array<double, NonparametricFactors::nodes>& curve, const NodeInterval& at) {
  return (1 - at.fraction) * curve[at.index] + at.fraction * curve[at.index + 1];
}

const double smallestCosine = std::cos(radians(89.5));

}  // namespace

NodeInterval nonparametricInterval(double position) {
  const double x = std::clamp(position, 0.0, double(NonparametricFactors::nodes - 1));
  const std::size_t index = std::min(std::size_t(x), NonparametricFactors::nodes - 2);
  return {index, x - double(index)};
}

std::shared_ptr<const Brdf> makeNonparametricBrdf(NonparametricFactors factors) {
  return makePairwiseBrdf([f = std::move(factors)](const Direction& wi, const Direction& wo) {
    const HalfDifference at = toHalfDifference(wi, wo);
    Rgb result(0);
    if (!at.valid) return result;
    const HalfDifferenceGrid::Position position = HalfDifferenceGrid{}.position(at);
    const NodeInterval d = nonparametricInterval(position.thetaH), fresnel = nonparametricInterval(position.thetaD),
                       i = maskingInterval(polarAngle(wi)), o = maskingInterval(polarAngle(wo));
    const double cosines = std::max(wi.z, smallestCosine) * std::max(wo.z, smallestCosine);
    for (int channel = 0; channel < 3; ++channel) {
      const NonparametricFactors::Channel& c = f.channels[std::size_t(channel)];
      const double lobe = between(c.d, d) * between(c.f, fresnel) * between(c.g, i) * between(c.g, o) / cosines;
      result[channel] = (c.diffuse + c.specular * lobe) / pi;
    }
    return result;
  });
}

}  // namespace gonio::factorization
