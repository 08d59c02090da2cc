// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>

#include "core/fitting/azimuth_cells.h"
#include "core/fitting/fit.h"
#include "core/fitting/projected_problem.h"

namespace gonio::fitting {

/// What the fits of all models to one material share: which cells count, and the parts of them that are compared.
class FitData {
 public:
  /// `base` lives as long as this. Of a table its cells, some 0.1 s for a MERL table; of an anisotropic BRDF cells over
  /// all azimuths of both directions (azimuthCells()), about 0.2 s; any other is sampled as a MERL table first.
  FitData(const Brdf& base, const FitOptions& options);

  const FitOptions& options() const { return options_; }
  /// A model without these parameters along two axes fits data of either kind.
  DataSymmetry symmetry() const { return table_ ? DataSymmetry::isotropic : DataSymmetry::anisotropic; }
  std::size_t usedCells() const { return table_ ? census_.used : azimuths_.used; }
  std::size_t invalidCells() const { return table_ ? census_.invalid : azimuths_.invalid; }
  std::size_t grazingCells() const { return table_ ? census_.grazing : azimuths_.grazing; }
  /// Over all cells, in the order of metrics::allBrdfMetrics(). In parallel.
  std::vector<double> errors(const Brdf& fitted) const;
  /// What is amiss with the measurement, for people; usually nothing.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// About 3,000 cells of a MERL table find the minimum, the others settle it: about 20,000 for models with few
  /// non-linear parameters, 10,000 for the others, whose evaluations are many and dear. Made on first use, by one
  /// thread at a time. There are cells that count.
  const FitTarget& search() const;
  const FitTarget& polish(std::size_t nonlinearParameters) const;

 private:
  /// How finely the cells are looked at.
  enum class Part { search, fine, coarse };
  FitTarget makeTarget(Part part, double costTolerance) const;

  const Brdf& base_;
  FitOptions options_;
  std::shared_ptr<const TabulatedBrdf> baked_;  ///< of an isotropic base without a table
  const TabulatedBrdf* table_;                  ///< null of anisotropic data
  CellCensus census_;                           ///< of the table
  AzimuthCensus azimuths_;                      ///< else
  FitCells allCells_;                           ///< of anisotropic data
  std::vector<std::string> warnings_;
  mutable std::optional<FitTarget> search_, fine_, coarse_;
};

/// As fit(table, model, options, control), whose preparation is the data's constructor.
/// @param choices values of all parameters, of which those of choices (conventions) are kept; empty: the defaults.
FitResult fit(const FitData& data, const models::Model& model, const TaskControl& control = {},
              const models::ParameterValues& choices = {});

}  // namespace gonio::fitting
