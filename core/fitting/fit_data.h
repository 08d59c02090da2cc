// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>

#include "core/fitting/fit.h"
#include "core/fitting/projected_problem.h"

namespace gonio::fitting {

/// What the fits of all models to one table share: which cells count, and the parts of them that are compared.
class FitData {
 public:
  /// `table` lives as long as this. Some 0.1 s for a MERL table.
  FitData(const TabulatedBrdf& table, const FitOptions& options);

  const TabulatedBrdf& table() const { return table_; }
  const FitOptions& options() const { return options_; }
  const CellCensus& census() const { return census_; }
  /// What is amiss with the measurement, for people; usually nothing.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// About 3,000 cells of a MERL table find the minimum, the others settle it: about 20,000 for models with few
  /// non-linear parameters, 10,000 for the others, whose evaluations are many and dear. Made on first use, by one
  /// thread at a time. There are cells that count.
  const FitTarget& search() const;
  const FitTarget& polish(std::size_t nonlinearParameters) const;

 private:
  FitTarget makeTarget(int thetaDStrata, int phiDStrata, double costTolerance) const;

  const TabulatedBrdf& table_;
  FitOptions options_;
  CellCensus census_;
  std::vector<std::string> warnings_;
  mutable std::optional<FitTarget> search_, fine_, coarse_;
};

/// As fit(table, model, options, control), whose preparation is the data's constructor.
/// @param choices values of all parameters, of which those of choices (conventions) are kept; empty: the defaults.
FitResult fit(const FitData& data, const models::Model& model, const TaskControl& control = {},
              const models::ParameterValues& choices = {});

}  // namespace gonio::fitting
