// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/reconstruction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/acquisition/sample_rows.h"
#include "core/acquisition/sparse_samples.h"
#include "core/math/parallel.h"
#include "core/math/ridge_regression.h"
#include "core/support/error.h"

namespace gonio::acquisition {

namespace {

using dictionary::PrincipalComponents;

/// The variance of a coefficient over the training set: the columns of V have length 1 and, of centred data, mean 0.
double trainingVariance(const PrincipalComponents& basis) {
  return 1 / double(std::max<Eigen::Index>(1, basis.svd.v.rows()));
}

void check(const ReconstructionOptions& options) {
  if (options.ridge && !(*options.ridge >= 0)) throw Error("the ridge must be a number, 0 or more");
  if (options.noise && !(*options.noise >= 0 && std::isfinite(*options.noise)))
    throw Error("the noise must be a number, 0 or more");
  if (options.components < 0 || options.atoms < 0) throw Error("a number of components must be 0 or more");
}

/// Equations of noisy samples count less: both sides times the root of the weight.
void weigh(SampleRows& samples, double variance) {
  if (samples.variances.size() == 0) return;
  const Eigen::VectorXd roots = (1 + samples.variances.array() / variance).rsqrt();
  samples.rows = roots.asDiagonal() * samples.rows;
  samples.values = roots.asDiagonal() * samples.values;
}

/// v of the coefficients (Reconstruction::deviation).
double coefficientVariance(const PrincipalComponents& basis, const RidgeRegression& regression, double ridge,
                           const std::optional<double>& noise) {
  const double training = trainingVariance(basis);
  if (!std::isfinite(ridge)) return training;
  if (noise && ridge > 0) return *noise * *noise / ridge;
  return (training + regression.weightedEnergy(ridge)) / (1 + 3 * double(regression.rowCount()));
}

/// The length of each row of D F, F the square root of the coefficients' covariance.
std::vector<float> deviations(const PrincipalComponents& basis, const Eigen::MatrixXd& factor,
                              const TaskControl& control) {
  constexpr std::size_t blockCells = 2048;
  const Eigen::Index components = factor.rows();
  const Eigen::MatrixXf scaled = (basis.svd.singularValues.head(components).asDiagonal() * factor).cast<float>();
  const auto u = basis.svd.u.view().leftCols(components);
  std::vector<float> result(basis.mapping.cells.size());
  parallelForBlocks(
      result.size(), blockCells,
      [&](std::size_t begin, std::size_t end) {
        // Into aligned memory of its own: how Eigen sums depends on where the result lies.
        const Eigen::VectorXf lengths =
            (u.middleRows(Eigen::Index(begin), Eigen::Index(end - begin)) * scaled).rowwise().norm();
        std::copy(lengths.begin(), lengths.end(), result.begin() + std::ptrdiff_t(begin));
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

/// Coefficients of the ridge, and what the result tells of it.
Eigen::MatrixXd solveRidge(const PrincipalComponents& basis, const SampleRows& samples,
                           const ReconstructionOptions& options, Reconstruction& result, const TaskControl& control) {
  const RidgeRegression regression(samples.rows, samples.values);
  result.ridge = options.ridge ? *options.ridge : regression.leaveOneOutRidge(publishedRidge);
  if (result.ridge > 0 && std::isfinite(result.ridge) && samples.rows.rows() > 1)
    result.leaveOneOutError =
        std::sqrt(regression.leaveOneOut(result.ridge).squaredNorm() / double(samples.values.size()));
  if (options.uncertainty) {
    const double variance = coefficientVariance(basis, regression, result.ridge, options.noise);
    result.deviation = deviations(basis, std::sqrt(variance) * regression.posteriorFactor(result.ridge), control);
  }
  return regression.coefficients(result.ridge);
}

}  // namespace

Reconstruction reconstruct(const PrincipalComponents& basis, const SamplingPlan& plan, const MeasuredValues& values,
                           const ReconstructionOptions& options, const TaskControl& control) {
  check(options);
  const int wanted = options.components > 0 ? options.components : int(plan.samples.size());
  Reconstruction result;
  result.components = std::min(wanted, basis.count());
  result.leaveOneOutError = std::numeric_limits<double>::quiet_NaN();
  SampleRows samples = sampleRows(basis, plan, values, result.components);
  weigh(samples, publishedRidge * trainingVariance(basis));
  Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(result.components, 3);
  if (result.components == 0)
    result.ridge = options.ridge.value_or(publishedRidge);
  else if (options.method == ReconstructionMethod::ridge)
    coefficients = solveRidge(basis, samples, options, result, control.between(0, 0.5));
  else
    coefficients = sparseCoefficients(samples, options.atoms, control.between(0, 0.5));
  result.code = codeOf(basis, coefficients);
  result.table = dictionary::decode(basis, result.code, control.between(0.5, 1), &result.cappedCount);
  return result;
}

}  // namespace gonio::acquisition
