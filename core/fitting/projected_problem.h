// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/fitting/fit_cells.h"
#include "core/fitting/linear_solve.h"
#include "core/models/model.h"
#include "core/models/parameter_spec.h"

namespace gonio::fitting {

/// Scales a parameter for solvers: its soft range becomes [0, 1], logarithmically if the spec says so.
class UnitScale {
 public:
  explicit UnitScale(const models::ParameterSpec& spec);

  double toUnit(double value) const;
  /// Always inside the hard range.
  double toValue(double unit) const;
  /// The hard range in units. For a logarithmic scale with a hard minimum of 0 it ends some decades below the soft
  /// range.
  double minimum() const { return minimum_; }
  double maximum() const { return maximum_; }

 private:
  bool logarithmic_;
  double hardMin_, hardMax_;
  double origin_, extent_;  ///< of the soft range, on the linear or logarithmic scale
  double minimum_, maximum_;
};

/// The data of a fit: cells, and the measurement in the domain of the metric, computed once for all problems.
struct FitTarget {
  FitCells cells;
  MetricTransform metric;
  std::vector<double> factor;      ///< factor of the metric per BRDF value
  std::vector<double> rootWeight;  ///< square root of the cell's weight times the metric's; the sum of squares is 1
  std::array<std::vector<double>, 3> transformed;  ///< transform(measured * factor)
  std::array<std::vector<double>, 3> startWeight;  ///< rootWeight * slope(measured * factor) * factor

  double costTolerance;  ///< for the linear parameters, see ChannelProblem

  FitTarget(FitCells fitCells, MetricTransform fitMetric, double linearCostTolerance = 1e-13);
};

/// A least-squares problem in the non-linear parameters only; the linear parameters are solved for each trial (variable
/// projection, Golub and Pereyra 1973). The Jacobian is that of Kaufman 1975: the change of the residual at fixed
/// linear parameters, without the part that a change of the linear parameters can compensate; its gradient is exact.
///
/// Where the data do not determine a parameter (such as f0 of a matte material), a weak regularisation toward the
/// defaults determines it: the cost is multiplied by 1 + preference |u - u_default|^2. An exact fit (cost 0) is not
/// biased by it.
class ProjectedProblem {
 public:
  static constexpr double preference = 1e-3;

  /// @param base values of all parameters. @param freeParameters indices of the unknowns, non-linear parameters.
  /// @param channels fitted together. With one channel, per-channel parameters are those of that channel.
  ProjectedProblem(const models::Model& model, const FitTarget& target, const models::ParameterValues& base,
                   std::vector<std::size_t> freeParameters, std::vector<int> channels);

  int unknownCount() const { return int(unknowns_.size()); }
  int residualCount() const { return int(target_.cells.size() * channels_.size()); }
  const UnitScale& scale(int unknown) const { return unknowns_[std::size_t(unknown)].scale; }
  /// The values that `values` has for the unknowns, converted to units of UnitScale.
  std::vector<double> unitsOf(const models::ParameterValues& values) const;

  /// Sum of squared residuals at `units`; solves the linear parameters.
  double cost(std::span<const double> units);
  /// Writes residualCount() values for the units of the last call of cost().
  void residuals(double* out) const;
  /// Writes the Jacobian for the units of the last call of cost(): residualCount() x unknownCount(), row-major.
  void jacobian(double* out) const;

  /// The best parameters found, including the linear ones of this problem's channels; all others as in `base`.
  models::ParameterValues bestParameters() const;
  double bestCost() const { return bestCost_; }

 private:
  struct Unknown {
    std::size_t parameter;
    int channel;  ///< -1: all of them
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
  std::size_t perturbedTogether(std::size_t first) const;
  std::vector<Rgb> perturbedModel(std::size_t first, std::size_t count) const;

  const models::Model& model_;
  const FitTarget& target_;
  models::ParameterValues base_;
  std::vector<int> channels_;
  std::vector<std::size_t> linear_;
  std::vector<Unknown> unknowns_;
  bool sharesBases_;                        ///< whether the bases are the same in all fitted channels
  std::vector<std::vector<double>> bases_;  ///< [slot][linear parameter], unit strength
  std::vector<double> units_;               ///< of the last call of cost()
  std::vector<ChannelSolution> solutions_;  ///< at `units_`, one per channel
  std::vector<double> bestUnits_;
  std::vector<LinearVector> bestLinear_;
  double bestCost_;
};

}  // namespace gonio::fitting
