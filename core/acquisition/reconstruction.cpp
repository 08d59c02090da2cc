// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/reconstruction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/acquisition/local_ridge.h"
#include "core/acquisition/noisy_ridge.h"
#include "core/acquisition/sample_rows.h"
#include "core/acquisition/sparse_samples.h"
#include "core/math/parallel.h"
#include "core/support/error.h"
#include "core/support/number_text.h"

namespace gonio::acquisition {

namespace {

using dictionary::PrincipalComponents;

/// The variance of a coefficient over the training set: the columns of V have length 1 and, of centred data, mean 0.
double trainingVariance(const PrincipalComponents& basis) {
  return 1 / double(std::max<Eigen::Index>(1, basis.svd.v.rows()));
}

void checkOptions(const ReconstructionOptions& options) {
  if (options.ridge && !(*options.ridge >= 0))
    throw Error("found the ridge " + numberText(*options.ridge) + ", expected a number, 0 or more");
  if (options.noise && !(*options.noise >= 0 && std::isfinite(*options.noise)))
    throw Error("found the noise " + numberText(*options.noise) + ", expected a finite number, 0 or more");
  if (options.components < 0 || options.atoms < 0) throw Error("a number of components must be 0 or more");
}

/// v of the coefficients (Reconstruction::standardDeviation). Known noise does not grow with the coefficients, so
/// the weight of each sample is the fraction of its noise that is not known: a sample with much known noise does not
/// show their size.
double coefficientVariance(const PrincipalComponents& basis, const SampleRows& samples, const Eigen::VectorXd& noise,
                           double ridge, const std::optional<double>& given) {
  const double training = trainingVariance(basis);
  if (!std::isfinite(ridge)) return training;
  if (given && ridge > 0) return *given * *given / ridge;
  Eigen::ArrayXd worth = Eigen::ArrayXd::Ones(samples.knownNoise.size());
  for (Eigen::Index i = 0; i < worth.size(); ++i)
    if (samples.knownNoise[i] > 0) worth[i] -= samples.knownNoise[i] / (ridge * training + samples.variances[i]);
  SampleRows counted = samples;
  counted.values = worth.max(0).sqrt().matrix().asDiagonal() * samples.values;
  return (training + NoisyRidge(counted, noise, ridge).weightedEnergy()) / (1 + 3 * worth.sum());
}

/// Of coefficients with the covariance `variance` F F^T given the samples: the length of each row of D F, and what the
/// other components add, on which the samples carry no information: `leftOutScale` times their variance over the
/// training set.
std::vector<float> deviations(const PrincipalComponents& basis, const Eigen::MatrixXd& factor, double variance,
                              double leftOutScale, const TaskControl& control) {
  constexpr std::size_t blockCells = 2048;
  const Eigen::Index components = factor.rows();
  const Eigen::MatrixXf scaled =
      (std::sqrt(variance) * (basis.svd.singularValues.head(components).asDiagonal() * factor)).cast<float>();
  const auto u = basis.svd.u.view().leftCols(components);
  const auto scale = float(leftOutScale);
  std::vector<float> result(basis.mapping.cells.size());
  parallelForBlocks(
      result.size(), blockCells,
      [&](std::size_t begin, std::size_t end) {
        // Into aligned memory of its own: how Eigen sums depends on where the result lies.
        const Eigen::VectorXf squares =
            (u.middleRows(Eigen::Index(begin), Eigen::Index(end - begin)) * scaled).rowwise().squaredNorm();
        const std::vector<float> leftOut = leftOutVariance(basis, int(components), begin, end);
        for (std::size_t i = begin; i < end; ++i)
          result[i] = std::sqrt(squares[Eigen::Index(i - begin)] + scale * leftOut[i - begin]);
      },
      control);
  return result;
}

dictionary::ComponentCode codeOf(const PrincipalComponents& basis, const Eigen::MatrixXd& coefficients) {
  dictionary::ComponentCode code;
  for (Eigen::Index channel = 0; channel < 3; ++channel)
    code.channels[std::size_t(channel)] =
        basis.svd.singularValues.head(coefficients.rows()).cwiseProduct(coefficients.col(channel)).cast<float>();
  return code;
}

/// Coefficients of the ridge, and what the result states about it.
Eigen::MatrixXd solveRidge(const PrincipalComponents& basis, const SampleRows& samples,
                           const ReconstructionOptions& options, Reconstruction& result, const TaskControl& control) {
  const Eigen::VectorXd noise = samples.variances / trainingVariance(basis);
  result.ridge = options.ridge ? *options.ridge : leaveOneOutRidge(samples, noise, control.between(0, 0.5));
  const NoisyRidge regression(samples, noise, result.ridge);
  if (result.ridge > 0 && std::isfinite(result.ridge) && samples.rows.rows() > 1)
    result.leaveOneOutError = std::sqrt(regression.leaveOneOut().squaredNorm() / double(samples.values.size()));
  if (options.uncertainty) {
    const double variance = coefficientVariance(basis, samples, noise, result.ridge, options.noise);
    result.standardDeviation = deviations(basis, regression.posteriorFactor(), variance,
                                          variance / trainingVariance(basis), control.between(0.5, 1));
  }
  return regression.coefficients();
}

/// The same for the local ridge.
Eigen::MatrixXd solveLocalRidge(const PrincipalComponents& basis, const SampleRows& samples,
                                const ReconstructionOptions& options, Reconstruction& result,
                                const TaskControl& control) {
  const LocalRidge local = localRidge(samples, basis.svd.v, options.uncertainty, control.between(0, 0.5));
  result.ridge = local.ridge;
  result.leaveOneOutError = local.leaveOneOutError;
  if (options.uncertainty)
    result.standardDeviation =
        deviations(basis, local.posteriorFactor, local.scale, local.scale, control.between(0.5, 1));
  return local.coefficients;
}

}  // namespace

ReconstructionOptions publishedReconstruction() {
  return {.ridge = publishedRidge, .equalNoise = true, .componentsAsSamples = true};
}

Reconstruction reconstruct(const PrincipalComponents& basis, const SamplingPlan& plan, const MeasuredValues& values,
                           const ReconstructionOptions& options, const TaskControl& control) {
  checkOptions(options);
  Reconstruction result;
  const int wanted = options.componentsAsSamples ? int(plan.samples.size()) : options.components;
  result.components = wanted > 0 ? std::min(wanted, basis.count()) : basis.count();
  result.leaveOneOutError = std::numeric_limits<double>::quiet_NaN();
  SampleRows samples = sampleRows(basis, plan, values, result.components);
  if (options.equalNoise) {
    samples.variances.setZero();
    samples.knownNoise.setZero();
  }
  Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(result.components, 3);
  if (result.components == 0)
    result.ridge = options.ridge.value_or(publishedRidge);
  else if (options.method == ReconstructionMethod::localRidge && samples.rows.rows() > 1)
    coefficients = solveLocalRidge(basis, samples, options, result, control.between(0, 0.5));
  else if (options.method != ReconstructionMethod::sparse)
    coefficients = solveRidge(basis, samples, options, result, control.between(0, 0.5));
  else
    coefficients = sparseCoefficients(samples, options.atoms, control.between(0, 0.5));
  result.code = codeOf(basis, coefficients);
  result.table = dictionary::decode(basis, result.code, control.between(0.5, 1), &result.cappedCount);
  return result;
}

}  // namespace gonio::acquisition
