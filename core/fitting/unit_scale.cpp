// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/unit_scale.h"

#include <algorithm>
#include <cmath>

namespace gonio::fitting {

namespace {

/// Where a logarithmic range starts whose spec starts at 0.
constexpr double minFraction = 1e-4;

}  // namespace

UnitScale::UnitScale(const models::ParameterSpec& spec)
    : logarithmic_(spec.scale == models::ParameterScale::logarithmic), hardMin_(spec.hardMin), hardMax_(spec.hardMax) {
  const double softMin = logarithmic_ && !(spec.softMin > 0) ? spec.softMax * minFraction : spec.softMin;
  const auto scaled = [&](double value) { return logarithmic_ ? std::log(value) : value; };
  origin_ = scaled(softMin);
  extent_ = scaled(spec.softMax) - origin_;
  if (!(extent_ > 0)) extent_ = 1;
  const double hardMinimum = logarithmic_ && !(spec.hardMin > 0) ? softMin * minFraction : spec.hardMin;
  minimum_ = (scaled(hardMinimum) - origin_) / extent_;
  maximum_ = (scaled(spec.hardMax) - origin_) / extent_;
}

double UnitScale::toUnit(double value) const {
  if (logarithmic_ && !(value > 0)) return minimum_;
  return std::clamp(((logarithmic_ ? std::log(value) : value) - origin_) / extent_, minimum_, maximum_);
}

double UnitScale::toValue(double unit) const {
  const double scaled = origin_ + std::clamp(unit, minimum_, maximum_) * extent_;
  return std::clamp(logarithmic_ ? std::exp(scaled) : scaled, hardMin_, hardMax_);
}

}  // namespace gonio::fitting
