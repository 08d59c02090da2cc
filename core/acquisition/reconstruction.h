// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/acquisition/measured_values.h"
#include "core/acquisition/sample_rows.h"
#include "core/dictionary/principal_components.h"
#include "core/math/regression.h"
#include "core/support/task_control.h"

namespace gonio::acquisition {

// Ridge regression of samples that differ in their noise: sample i has noise of variance v (eta + n_i), where v is the
// variance of the coefficients. Q is SampleRows::rows, y SampleRows::values.

class NoisyRidge {
 public:
  /// @param noise n_i >= 0. @param ridge eta. Cost: one RidgeRegression.
  NoisyRidge(const SampleRows& samples, const Eigen::VectorXd& noise, double ridge);

  /// (Q^T N^-1 Q + I)^-1 Q^T N^-1 y, N = diag(eta + n): components x channels.
  Eigen::MatrixXd coefficients() const { return regression_.coefficients(scaledRidge_); }
  /// The symmetric F with F F = (Q^T N^-1 Q + I)^-1, which is the covariance of coefficients of variance 1 given the
  /// samples.
  Eigen::MatrixXd posteriorFactor() const { return regression_.posteriorFactor(scaledRidge_); }
  /// trace(y^T (Q Q^T + N)^-1 y) (RidgeRegression::weightedEnergy).
  double weightedEnergy() const { return regression_.weightedEnergy(scaledRidge_); }
  /// Each sample's values minus their prediction from all other samples: samples x channels. Requires that all eta +
  /// n_i are positive and finite.
  Eigen::MatrixXd leaveOneOut() const;

 private:
  double scaledRidge_;
  Eigen::VectorXd roots_;  ///< factors that scale the equations so that all have noise of variance scaledRidge_
  RidgeRegression regression_;
};

/// The eta for which each sample is predicted best from all others: it minimises the sum over the samples of (squared
/// difference) / (publishedRidge + n_i), so that noisy samples have little influence. Tries
/// RidgeRegression::triedRidges() and takes bestRidge() of them, or publishedRidge if there are none. Parallel; the
/// result does not depend on the number of threads. @throws Cancelled.
double leaveOneOutRidge(const SampleRows& samples, const Eigen::VectorXd& noise, const TaskControl& control = {});

/// Coefficients of a few components, per channel: orthogonal matching pursuit on the rows of D chooses the components,
/// least squares determines the coefficients.
/// @param atoms maximum number of components per channel; 0: the number, from 1 to half the samples, that predicts each
/// sample best from all others. @return components x channels. Cost: O(samples components) per atom and channel; with
/// atoms = 0 a pursuit of half the samples for each sample and channel, O(samples^3 components). @throws Cancelled
/// between two pursuits.
/// @param largest absolute value of a coefficient; of nearly dependent samples, fewer atoms are used until no
/// coefficient exceeds it.
Eigen::MatrixXd sparseCoefficients(const SampleRows& samples, int atoms, const TaskControl& control = {},
                                   double largest = std::numeric_limits<double>::infinity());

/// Coefficients with the smallest sum of absolute values, per channel: Lasso over the rows of D, with the penalty that
/// predicts samples best from the others, among 25 from the largest useful one down to 1e-6 of it (ten groups are left
/// out in turn). Without noise and with fewer samples than components, a small penalty is the basis pursuit of section
/// 3.2 of Tongbuasirilai 2023. @return components x channels. O(samples components) a sweep, some thousand sweeps.
/// @throws Cancelled between two penalties.
Eigen::MatrixXd basisPursuitCoefficients(const SampleRows& samples, const TaskControl& control = {});

// Reconstruction of a whole material from a few measured values and the principal components of other materials
// (Nielsen et al. 2015, "On Optimal, Minimal BRDF Sampling for Reflectance Acquisition"; Tongbuasirilai 2023,
// "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition", eq. 5.14).

enum class ReconstructionMethod {
  ridge,        ///< c = (Q^T Q + eta I)^-1 Q^T (y - mean), Q the rows of D = U Sigma at the samples
  sparse,       ///< few components, chosen by orthogonal matching pursuit; coefficients by least squares
  localRidge,   ///< ridge regression over the training signals that resemble the samples (local_ridge.h); with one
                ///< sample, `ridge`
  basisPursuit  ///< the smallest sum of absolute coefficients (basisPursuitCoefficients())
};
/// Names in JSON and on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 4> reconstructionMethodNames{"ridge", "sparse", "local-ridge",
                                                                           "basis-pursuit"};

/// Whether the method has an uncertainty, Reconstruction::standardDeviation.
inline bool hasUncertainty(ReconstructionMethod method) {
  return method == ReconstructionMethod::ridge || method == ReconstructionMethod::localRidge;
}

/// Condition number of the rows of D at the samples above which plans and reconstructions state a warning: noise of a
/// reading may be amplified by this factor.
inline constexpr double maxReliableCondition = 1e4;

/// eta of Nielsen et al. 2015 and Tongbuasirilai 2023. It is absolute: with a training set of t columns the
/// coefficients have variance 1/t, so it assumes that a mapped value has noise of standard deviation sqrt(40 / t) (0.31
/// for 411 columns).
inline constexpr double publishedRidge = 40;

struct ReconstructionOptions {
  ReconstructionMethod method = ReconstructionMethod::ridge;
  std::optional<double> ridge;  ///< `ridge` only: eta >= 0, e.g. publishedRidge; if empty, chosen by leaveOneOutRidge()
  int components = 0;  ///< number of components of the basis to use; may exceed the number of samples; 0, or more than
                       ///< the basis has: all
  int atoms = 0;  ///< `sparse` only: components per channel; 0: chosen by leave-one-out, at most half the number of
                  ///< samples
  std::optional<double> noise;  ///< `ridge` only: standard deviation of a mapped value, for `standardDeviation`; if
                                ///< empty, estimated
  bool uncertainty = true;      ///< whether to compute `standardDeviation`; needs hasUncertainty()
  /// Whether all samples have the same weight, as in eq. 5.14 as printed: eta is used alone. Otherwise the variance of
  /// the components that are not used and the standard deviations of the values count as noise (see reconstruct()).
  bool equalNoise = false;
  bool componentsAsSamples = false;  ///< whether to use as many components as samples, instead of `components`
};

/// What every reconstruction assumes of the two directions, since the training materials are the means of both orders
/// (TabulatedBrdf::meanOfOrders()).
inline constexpr std::string_view assumedOrders = "reciprocal: a reading also stands for light and viewer exchanged";

/// The options of the published method: eq. 5.14 with eta = 40 and as many components as samples (Nielsen et al. 2015;
/// Tongbuasirilai 2023; the authors' code).
ReconstructionOptions publishedReconstruction();

struct Reconstruction {
  std::shared_ptr<const TabulatedBrdf> table;
  dictionary::ComponentCode code;  ///< over the components of the basis
  std::size_t cappedCount = 0;     ///< channel values beyond the range of float, stored as the largest float
  double ridge = 0;                ///< eta that was used (LocalRidge::ridge); 0 without hasUncertainty()
  int components = 0;              ///< number of components used
  /// Root mean squared difference between each mapped value and its prediction from all other samples (`ridge` with a
  /// finite eta > 0; `localRidge`: LocalRidge::leaveOneOutError): the error to expect at a cell that resembles the
  /// measured ones. NaN for one sample, and without hasUncertainty().
  double leaveOneOutError = 0;
  /// Posterior standard deviation of the mapped value of each cell of basis.mapping.cells, or empty. A change
  /// of a mapped value by d multiplies rho w + 1e-3 by e^d (core/brdf/data_transform.h).
  ///
  /// `localRidge`: from LocalRidge::posteriorFactor and LocalRidge::scale. `ridge`: under the Gaussian model in which
  /// the coefficients of the ridge are the most likely ones. All coefficients have variance v, including those of
  /// components that are not used and of what the basis leaves out; a sample has additional noise of variance eta v. If
  /// `noise` is given (and eta > 0, finite), v = noise^2 / eta. Otherwise v is estimated as the most likely value given
  /// the samples of all channels and one additional value with the variance 1/t of the training set; if eta is
  /// infinite, v = 1/t. In this estimate, each sample has a weight equal to the fraction of its noise that is not
  /// known; if known noise dominates, v is therefore 1/t. In this model, what the components that are not used add
  /// is independent from cell to cell, so samples carry no information about it.
  std::vector<float> standardDeviation;
  /// For the user, usually empty: readings that repeat each other (SampleRows), samples whose rows have a condition
  /// number above maxReliableCondition.
  std::vector<std::string> warnings;
};

/// Each sample is read at the nearest node of the basis (nearestNode()), which both orders of its directions share: the
/// result is reciprocal (assumedOrders). Components that are not used count as noise of
/// a sample, and so do the standard deviations of the values if given: eta is replaced by eta + t (l + s^2) (unless
/// `equalNoise`), with t the number of training signals, l the variance that is left out (leftOutVariance()), and s the
/// standard deviation of the mapped value to first order (root mean square of the channels). The three channels share
/// these weights, so one factorisation solves all of them.
/// Cells outside basis.mapping.cells are invalid, as in decode(). Cost: O(samples components min(samples, components)),
/// about a hundred times that if the ridge is chosen, + O(cells components), or O(cells components^2) with the
/// uncertainty.
/// @throws Error if there are no samples or their number differs from that of the values, a value is negative, not
/// finite or too large for a BRDF value, a sample lies in a cell without training data (the message names its index),
/// or an option is out of range; Cancelled.
Reconstruction reconstruct(const dictionary::PrincipalComponents& basis, const SamplingPlan& plan,
                           const MeasuredValues& values, const ReconstructionOptions& options = {},
                           const TaskControl& control = {});

/// As reconstruct(), but without decoding the code: `table` is null and `cappedCount` 0. Cost and exceptions: as there,
/// without O(cells components).
Reconstruction reconstructCode(const dictionary::PrincipalComponents& basis, const SamplingPlan& plan,
                               const MeasuredValues& values, const ReconstructionOptions& options = {},
                               const TaskControl& control = {});

}  // namespace gonio::acquisition
