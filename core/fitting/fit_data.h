// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/fitting/fit.h"
#include "core/fitting/fit_cells.h"
#include "core/fitting/projected_problem.h"
#include "core/metrics/brdf_metrics.h"

namespace gonio::fitting {

/// Data that the fits of all models to one material share: the used cells and stratified subsets of them.
class FitData {
 public:
  /// `base` must outlive this object. Uses the cells of a table (about 0.1 s for a MERL table), or cells over all
  /// azimuths of both directions for an anisotropic BRDF (azimuthCells(), about 0.2 s); other BRDFs are first sampled
  /// as a MERL table.
  FitData(const Brdf& base, const FitOptions& options) : FitData(base, base, options) {}
  /// @param measurement the BRDF that errors() refers to; must outlive this object.
  FitData(const Brdf& base, const Brdf& measurement, const FitOptions& options);

  const FitOptions& options() const { return options_; }
  /// isotropic for a table, anisotropic for cells over all azimuths. Models without parameters along two axes can be
  /// fitted to both.
  DataSymmetry symmetry() const { return table_ ? DataSymmetry::isotropic : DataSymmetry::anisotropic; }
  std::size_t usedCells() const { return table_ ? selection_.used : azimuths_.used; }
  std::size_t invalidCells() const { return table_ ? selection_.invalid : azimuths_.invalid; }
  std::size_t grazingCells() const { return table_ ? selection_.grazing : azimuths_.grazing; }
  /// Errors against the measurement, in the order of metrics::allBrdfMetrics(). Parallel.
  std::vector<double> errors(const Brdf& fitted) const;
  /// Problems of the measurement, for the user; usually empty.
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// The value of each channel, 1/sr, if all used cells (two or more) have the same, above 0.
  const std::array<std::optional<double>, 3>& constants() const { return constants_; }

  /// Subsets of the cells: search() to find the minimum (about 3,000 cells of a MERL table), polish() to refine it:
  /// about 20,000 cells for models with few non-linear parameters, 10,000 for others, which need more evaluations. Made
  /// at the first call; call from one thread at a time. Precondition: usedCells() > 0.
  const FitTarget& search() const;
  const FitTarget& polish(std::size_t nonlinearParameters) const;

 private:
  /// Density of a subset.
  enum class Part { search, fine, coarse };
  FitTarget makeTarget(Part part, double costTolerance) const;

  const Brdf& base_;
  metrics::SampledReference measurement_;
  FitOptions options_;
  std::shared_ptr<const TabulatedBrdf> baked_;  ///< if the base is isotropic but not a table
  const TabulatedBrdf* table_;                  ///< null for anisotropic data
  CellSelection selection_;                     ///< for a table
  AzimuthCellCounts azimuths_;                  ///< for anisotropic data
  std::vector<std::string> warnings_;
  std::array<std::optional<double>, 3> constants_;
  mutable std::optional<FitTarget> search_, fine_, coarse_;
};

/// A measurement with fewer valid cells than this is warned about.
inline constexpr std::size_t fewCells = 10;

/// fit() with prepared data, to fit several models to one material. @param choices as for fit(base, ...).
FitResult fit(const FitData& data, const models::Model& model, const TaskControl& control = {},
              const models::ParameterValues& choices = {});

}  // namespace gonio::fitting
