// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/fit_data.h"

#include "core/fitting/fit_warnings.h"

namespace gonio::fitting {

namespace {

/// Patches of a theta_h row.
struct Strata {
  int thetaD, phiD;
};
constexpr Strata searchStrata{8, 5}, fineStrata{18, 18}, coarseStrata{14, 10};
constexpr std::size_t fewParameters = 3;
constexpr double searchTolerance = 1e-7, polishTolerance = 1e-13;

}  // namespace

FitData::FitData(const TabulatedBrdf& table, const FitOptions& options)
    : table_(table),
      options_(options),
      census_(takeCensus(table, options.maxPolarAngle)),
      warnings_(measurementWarnings(table, census_)) {}

FitTarget FitData::makeTarget(int thetaDStrata, int phiDStrata, double costTolerance) const {
  return {stratifiedCells(table_, census_, thetaDStrata, phiDStrata), MetricTransform(options_.metric, options_.gamma),
          costTolerance};
}

const FitTarget& FitData::search() const {
  if (!search_) search_ = makeTarget(searchStrata.thetaD, searchStrata.phiD, searchTolerance);
  return *search_;
}

const FitTarget& FitData::polish(std::size_t nonlinearParameters) const {
  const bool isFine = nonlinearParameters <= fewParameters;
  std::optional<FitTarget>& target = isFine ? fine_ : coarse_;
  const Strata strata = isFine ? fineStrata : coarseStrata;
  if (!target) target = makeTarget(strata.thetaD, strata.phiD, polishTolerance);
  return *target;
}

}  // namespace gonio::fitting
