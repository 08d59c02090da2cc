// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/fitting/fit_cells.h"
#include "core/fitting/linear_solve.h"
#include "core/fitting/unit_scale.h"
#include "core/models/model.h"

namespace gonio::fitting {

/// What a fit compares: the cells and, once for all problems over them, what the metric makes of the measurement.
struct FitTarget {
  FitCells cells;
  MetricTransform metric;
  std::vector<double> factor;                      ///< what the metric multiplies the reflectance by
  std::vector<double> rootWeight;                  ///< sqrt of the cells' weight times the metric's; they add up to 1
  std::array<std::vector<double>, 3> transformed;  ///< transform(measured factor)
  std::array<std::vector<double>, 3> startWeight;  ///< rootWeight slope(measured factor) factor

  double costTolerance;  ///< of the linear parameters, see ChannelProblem

  FitTarget(FitCells fitCells, MetricTransform fitMetric, double linearCostTolerance = 1e-13);
};

/// A least-squares problem in the non-linear parameters only (variable projection: Golub and Pereyra 1973): for each
/// trial the linear parameters are solved inside. The Jacobian is that of Kaufman (1975): the change of the residual at
/// fixed linear parameters, without the part that a change of these could undo; its gradient is exact.
///
/// To keep parameters defined where the data do not determine them (f0 of a matte material; f0 against the specular
/// strength), the cost is multiplied by 1 + preference |u - u_default|^2: a fit may be that much worse for staying near
/// the defaults, and one that explains the data completely is not biased at all.
class ProjectedProblem {
 public:
  static constexpr double preference = 1e-3;

  /// @param base values of all parameters; those in `freeParameters` (non-linear ones) are the unknowns.
  /// @param channels fitted together; one alone takes per-channel parameters as that channel's.
  ProjectedProblem(const models::Model& model, const FitTarget& target, const models::ParameterValues& base,
                   std::vector<std::size_t> freeParameters, std::vector<int> channels);

  int unknownCount() const { return int(unknowns_.size()); }
  int residualCount() const { return int(target_.cells.size() * channels_.size()); }
  const UnitScale& scale(int unknown) const { return unknowns_[std::size_t(unknown)].scale; }
  /// The unknowns of full parameter values, in units.
  std::vector<double> unitsOf(const models::ParameterValues& values) const;

  /// Sum of the squared residuals at unit values; solves the linear parameters.
  double cost(std::span<const double> units);
  /// At the last units given to cost(); residualCount() values.
  void residuals(double* out) const;
  /// At the last units given to cost(); row-major residualCount() x unknownCount().
  void jacobian(double* out) const;

  /// The best parameters seen: the linear ones of this problem's channels included, the others as in `base`.
  models::ParameterValues bestParameters() const;
  double bestCost() const { return bestCost_; }

 private:
  struct Unknown {
    std::size_t parameter;
    int channel;  ///< or all of them where -1
    UnitScale scale;
    double defaultUnit;
  };

  models::ParameterValues valuesAt(std::span<const double> units) const;
  void evaluateModel(const models::ParameterValues& values, std::vector<Rgb>& result) const;
  void evaluateBases(const models::ParameterValues& values);
  const std::vector<double>& basis(std::size_t slot, std::size_t j) const {
    return bases_[(sharesBases_ ? 0 : slot) * linear_.size() + j];
  }
  ChannelProblem channelProblem(std::size_t slot) const;
  double preferenceFactor(std::span<const double> units) const;
  std::vector<Rgb> perturbedModel(std::size_t first, std::size_t count) const;

  const models::Model& model_;
  const FitTarget& target_;
  models::ParameterValues base_;
  std::vector<int> channels_;
  std::vector<std::size_t> linear_;
  std::vector<Unknown> unknowns_;
  bool sharesBases_;                        ///< the bases are the same in all fitted channels
  std::vector<std::vector<double>> bases_;  ///< [slot][linear parameter], unit strength
  std::vector<double> units_;               ///< where cost() was last called
  std::vector<ChannelSolution> solutions_;  ///< there, one per channel
  std::vector<double> bestUnits_;
  std::vector<LinearVector> bestLinear_;
  double bestCost_;
};

}  // namespace gonio::fitting
