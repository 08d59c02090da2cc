// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/acquisition/measured_values.h"
#include "core/dictionary/principal_components.h"

/// A whole material from a few measurements and what is known of other materials (Nielsen et al. 2015, "On Optimal,
/// Minimal BRDF Sampling for Reflectance Acquisition"; dissertation eq. 5.14).
namespace gonio::acquisition {

enum class ReconstructionMethod {
  ridge,  ///< c = (Q^T Q + eta I)^-1 Q^T (y - mean), Q the rows of D = U Sigma at the samples
  sparse  ///< few components, chosen by orthogonal matching pursuit, with the coefficients of least squares
};
/// In JSON and on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 2> reconstructionMethodNames{"ridge", "sparse"};

/// eta of Nielsen et al. and of the dissertation. It is absolute: with a training set of t columns the coefficients
/// have a variance of 1/t, so it expects a noise of sqrt(40 / t) of a mapped value (0.31 for 411 columns).
inline constexpr double publishedRidge = 40;

struct ReconstructionOptions {
  ReconstructionMethod method = ReconstructionMethod::ridge;
  std::optional<double> ridge;  ///< eta >= 0, such as publishedRidge; without one by leave-one-out (leaveOneOutRidge())
  int components = 0;           ///< of the basis, may be more than samples; 0: all; never more than it has
  int atoms = 0;  ///< of `sparse`: components that are chosen per channel; 0: by leave-one-out, at most half as many
                  ///< as samples
  std::optional<double> noise;  ///< standard deviation of a mapped value for `deviation`; without one estimated
  bool uncertainty = true;      ///< whether `deviation` is made
};

struct Reconstruction {
  std::shared_ptr<const TabulatedBrdf> table;
  dictionary::ComponentCode code;  ///< over the basis
  std::size_t cappedCount = 0;     ///< channels of cells beyond the range of float
  double ridge = 0;                ///< eta that was used; 0 of `sparse`
  int components = 0;              ///< that could be used
  /// Root of the mean squared difference of each mapped value and what all other samples predict for it (`ridge` with
  /// eta > 0): the error to be expected at a cell like those measured. NaN of one sample, and of `sparse`.
  double leaveOneOutError = 0;
  /// Posterior standard deviation of the mapped value of each cell of basis.mapping.cells, `ridge` alone: under the
  /// model whose most likely coefficients the ridge gives. Coefficients have a variance v, those of components that
  /// are not used and of what the basis left out too; a sample has besides a noise of variance eta v. v is noise^2 /
  /// eta where `noise` was given (and eta > 0, finite), else its most likely value given the samples of all channels
  /// and one more at the training set's own 1/t, each counted for the fraction of its noise that is not known: known
  /// noise beyond all bounds leaves the training set's deviation. What is not used is independent from cell to cell in
  /// this model: a sample carries no information on it anywhere. A change of the mapped value by d is a factor of e^d
  /// of rho w + 1e-3.
  std::vector<float> deviation;
};

/// Samples are read at the node of the basis that is nearest to them (nearestNode()). What the components that are
/// used leave out of a sample is noise to them, and so are the standard deviations of the values where they are given:
/// eta + t (l + s^2) stands in place of eta, t the number of training signals, l the variance that is left out
/// (leftOutVariance()), s the deviation of the mapped value to first order, root mean square of the channels. One
/// weight for the three, so one factorisation solves them.
/// Cells that do not count in the basis are invalid, as in decode(). Cost: O(samples components min(samples,
/// components)), without a ridge a hundred times that, + O(cells components), with the uncertainty O(cells
/// components^2).
/// @throws Error when the numbers of samples and values differ or there are none, a value is negative or not finite or
/// beyond any reflectance, a sample lies where the basis knows nothing (naming its index), or an option is out of
/// range; Cancelled.
Reconstruction reconstruct(const dictionary::PrincipalComponents& basis, const SamplingPlan& plan,
                           const MeasuredValues& values, const ReconstructionOptions& options = {},
                           const TaskControl& control = {});

}  // namespace gonio::acquisition
