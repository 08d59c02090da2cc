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
/// Of anisotropic data: about half of the strata count, the others reach below the horizon.
constexpr AzimuthStrata searchAzimuths{60, 4, 3, 10}, fineAzimuths{90, 6, 6, 16}, coarseAzimuths{90, 5, 4, 12},
    allAzimuths{90, 10, 9, 24};
constexpr std::size_t fewParameters = 3;
constexpr double searchTolerance = 1e-7, polishTolerance = 1e-13;

/// What is fitted as a table but is none.
std::shared_ptr<const TabulatedBrdf> tableOf(const Brdf& base) {
  return formOf<TabulatedBrdf>(base) || !base.isIsotropic() ? nullptr : bakeTable(base);
}

}  // namespace

FitData::FitData(const Brdf& base, const Brdf& measurement, const FitOptions& options)
    : base_(base),
      measurement_(measurement),
      options_(options),
      baked_(tableOf(base)),
      table_(baked_ ? baked_.get() : formOf<TabulatedBrdf>(base)) {
  if (table_) {
    selection_ = selectCells(*table_, options.maxPolarAngle);
    warnings_ = measurementWarnings(*table_, selection_);
  } else {
    const FitCells cells = azimuthCells(base, options.maxPolarAngle, allAzimuths, azimuths_);
    warnings_ = measurementWarnings(cells, azimuths_.negative);
  }
}

std::vector<double> FitData::errors(const Brdf& fitted) const {
  return measurement_.errors(fitted, options_.maxPolarAngle, options_.gamma);
}

FitTarget FitData::makeTarget(Part part, double costTolerance) const {
  const MetricTransform metric(options_.metric, options_.gamma);
  if (table_) {
    const Strata strata = part == Part::search ? searchStrata : part == Part::fine ? fineStrata : coarseStrata;
    return {stratifiedCells(*table_, selection_, strata.thetaD, strata.phiD), metric, costTolerance};
  }
  AzimuthCellCounts counts;
  const AzimuthStrata strata = part == Part::search ? searchAzimuths
                               : part == Part::fine ? fineAzimuths
                                                    : coarseAzimuths;
  return {azimuthCells(base_, options_.maxPolarAngle, strata, counts), metric, costTolerance};
}

const FitTarget& FitData::search() const {
  if (!search_) search_ = makeTarget(Part::search, searchTolerance);
  return *search_;
}

const FitTarget& FitData::polish(std::size_t nonlinearParameters) const {
  const bool isFine = nonlinearParameters <= fewParameters;
  std::optional<FitTarget>& target = isFine ? fine_ : coarse_;
  if (!target) target = makeTarget(isFine ? Part::fine : Part::coarse, polishTolerance);
  return *target;
}

}  // namespace gonio::fitting
