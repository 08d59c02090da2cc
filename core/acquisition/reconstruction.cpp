// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/reconstruction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/acquisition/local_ridge.h"
#include "core/acquisition/sample_rows.h"
#include "core/math/decompositions.h"
#include "core/math/matching_pursuit.h"
#include "core/math/parallel.h"
#include "core/math/regression.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::acquisition {

namespace {

/// The least variance of a sample. Where some have none, a small part of the least that others have: the limit in which
/// the equations of those hold exactly is beyond double.
double leastVariance(const Eigen::VectorXd& noise, double ridge) {
  constexpr double exact = 1e-12;
  const double least = ridge + noise.minCoeff();
  if (least > 0) return least;
  double positive = 0;
  for (const double variance : noise)
    if (variance > 0 && (positive == 0 || variance < positive)) positive = variance;
  return exact * positive;
}

/// Square roots of the weights of samples with different noise. All are 1 if nothing differs, or for an infinite ridge.
Eigen::VectorXd rootWeights(const Eigen::VectorXd& noise, double ridge, double least) {
  return noise.unaryExpr([&](double variance) {
    return ridge + variance <= least || std::isinf(least) ? 1.0 : std::sqrt(least / (ridge + variance));
  });
}

}  // namespace

NoisyRidge::NoisyRidge(const SampleRows& samples, const Eigen::VectorXd& noise, double ridge)
    : scaledRidge_(leastVariance(noise, ridge)),
      roots_(rootWeights(noise, ridge, scaledRidge_)),
      regression_(roots_.asDiagonal() * samples.rows, roots_.asDiagonal() * samples.values) {}

Eigen::MatrixXd NoisyRidge::leaveOneOut() const {
  return roots_.cwiseInverse().asDiagonal() * regression_.leaveOneOut(scaledRidge_);
}

double leaveOneOutRidge(const SampleRows& samples, const Eigen::VectorXd& noise, const TaskControl& control) {
  const RidgeRegression plain(samples.rows, samples.values);
  if (noise.isZero(0)) return plain.leaveOneOutRidge(publishedRidge);
  const std::vector<double> ridges = plain.triedRidges();
  const Eigen::VectorXd roots = (publishedRidge + noise.array()).rsqrt();
  std::vector<double> sums(ridges.size());
  parallelForBlocks(
      ridges.size(), 1,
      [&](std::size_t begin, std::size_t) {
        const NoisyRidge regression(samples, noise, ridges[begin]);
        sums[begin] = (roots.asDiagonal() * regression.leaveOneOut()).squaredNorm();
      },
      control);
  return bestRidge(ridges, sums, publishedRidge);
}

namespace {

Eigen::VectorXd pursue(const AtomSet& atoms, const Eigen::VectorXd& signal, int steps) {
  const PursuitResult found = orthogonalMatchingPursuit(atoms, signal, {.steps = steps});
  Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(atoms.count());
  for (std::size_t a = 0; a < found.atoms.size(); ++a) coefficients[found.atoms[a]] = found.coefficients[a];
  return coefficients;
}

/// The matrix without one row.
Eigen::MatrixXd without(const Eigen::MatrixXd& matrix, Eigen::Index row) {
  Eigen::MatrixXd result(matrix.rows() - 1, matrix.cols());
  result << matrix.topRows(row), matrix.bottomRows(matrix.rows() - 1 - row);
  return result;
}

/// What pursuits of 1 to `most` steps predict for a row that they have not seen. The atoms of fewer steps are the first
/// ones of more, so one pursuit gives all: with A = Q R of the chosen columns and x their entries in the row, least
/// squares over the first k predict the sum of the first k entries of R^-T x times Q^T signal.
Eigen::ArrayXd predictions(const AtomSet& atoms, const Eigen::VectorXd& signal, const Eigen::RowVectorXd& row,
                           int most) {
  const PursuitResult found = orthogonalMatchingPursuit(atoms, signal, {.steps = most});
  IncrementalQr qr(atoms.length(), Eigen::Index(found.atoms.size()));
  Eigen::VectorXd along(Eigen::Index(found.atoms.size()));  // R^-T x
  Eigen::ArrayXd result(most);
  double sum = 0;
  for (int step = 0; step < most; ++step) {
    // A pursuit that ended before answers any larger number of steps with what it has.
    if (step < int(found.atoms.size())) {
      const int atom = found.atoms[std::size_t(step)];
      qr.append(atoms.matrix().col(atom));
      const auto newest = qr.r().col(step);
      along[step] = (row[atom] - newest.head(step).dot(along.head(step))) / newest[step];
      sum += along[step] * qr.q().col(step).dot(signal);
    }
    result[step] = sum;
  }
  return result;
}

/// The number of atoms, from 1, of the least squared error of prediction, for each channel.
Eigen::Array3i bestCounts(const SampleRows& samples, int most, const TaskControl& control) {
  const Eigen::Index count = samples.rows.rows();
  Eigen::ArrayX3d errors = Eigen::ArrayX3d::Zero(most, 3);
  for (Eigen::Index row = 0; row < count; ++row) {
    const AtomSet atoms(without(samples.rows, row));
    const Eigen::MatrixXd values = without(samples.values, row);
    for (Eigen::Index channel = 0; channel < 3; ++channel) {
      control.throwIfStopped();
      const Eigen::ArrayXd predicted = predictions(atoms, values.col(channel), samples.rows.row(row), most);
      errors.col(channel) += (samples.values(row, channel) - predicted).square();
    }
    control.report(double(row + 1) / double(count));
  }
  Eigen::Array3i best;
  for (Eigen::Index channel = 0; channel < 3; ++channel) {
    errors.col(channel).minCoeff(&best[channel]);
    ++best[channel];
  }
  return best;
}

}  // namespace

Eigen::MatrixXd sparseCoefficients(const SampleRows& samples, int atoms, const TaskControl& control, double largest) {
  const int most = std::max(1, int(samples.rows.rows()) / 2);
  Eigen::Array3i counts = Eigen::Array3i::Constant(atoms > 0 ? atoms : 1);
  if (atoms == 0 && most > 1) counts = bestCounts(samples, most, control);
  const AtomSet all(samples.rows);
  Eigen::MatrixXd coefficients(samples.rows.cols(), 3);
  for (Eigen::Index channel = 0; channel < 3; ++channel) {
    control.throwIfStopped();
    for (int count = counts[channel];; --count) {
      coefficients.col(channel) = pursue(all, samples.values.col(channel), count);
      if (count <= 1 || coefficients.col(channel).cwiseAbs().maxCoeff() <= largest) break;
    }
  }
  return coefficients;
}

namespace {

/// The penalties to try, relative to Lasso::largestPenalty(), descending: each solution starts the next.
std::vector<double> triedPenalties() {
  constexpr int count = 25, decades = 6;
  std::vector<double> penalties;
  for (int i = 1; i <= count; ++i) penalties.push_back(std::pow(10, -double(decades) * i / count));
  return penalties;
}

/// The rows of a matrix whose index has, or has not, the remainder `group` of a division by `groups`.
Eigen::MatrixXd rowsOfGroup(const Eigen::MatrixXd& matrix, Eigen::Index group, Eigen::Index groups, bool isIn) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    if ((row % groups == group) == isIn) rows.push_back(row);
  return matrix(rows, Eigen::all);
}

/// The index of the penalty with the least squared error of prediction of left-out samples, for each channel.
Eigen::Array3i bestPenalties(const SampleRows& samples, const std::vector<double>& penalties,
                             const TaskControl& control) {
  const Eigen::Index groups = std::min<Eigen::Index>(10, samples.rows.rows());
  std::vector<Eigen::ArrayX3d> errors(std::size_t(groups), Eigen::ArrayX3d::Zero(Eigen::Index(penalties.size()), 3));
  parallelForBlocks(
      std::size_t(groups), 1,
      [&](std::size_t group, std::size_t) {
        const auto g = Eigen::Index(group);
        const Lasso lasso(rowsOfGroup(samples.rows, g, groups, false));
        const Eigen::MatrixXd values = rowsOfGroup(samples.values, g, groups, false);
        const Eigen::MatrixXd rows = rowsOfGroup(samples.rows, g, groups, true),
                              expected = rowsOfGroup(samples.values, g, groups, true);
        for (Eigen::Index channel = 0; channel < 3; ++channel) {
          const double largest = lasso.largestPenalty(values.col(channel));
          Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(samples.rows.cols());
          for (std::size_t i = 0; i < penalties.size() && largest > 0; ++i) {
            control.throwIfStopped();
            lasso.solve(values.col(channel), penalties[i] * largest, coefficients);
            errors[group](Eigen::Index(i), channel) = (rows * coefficients - expected.col(channel)).squaredNorm();
          }
        }
      },
      control);
  Eigen::ArrayX3d sum = Eigen::ArrayX3d::Zero(Eigen::Index(penalties.size()), 3);
  for (const Eigen::ArrayX3d& part : errors) sum += part;
  Eigen::Array3i best;
  for (Eigen::Index channel = 0; channel < 3; ++channel) sum.col(channel).minCoeff(&best[channel]);
  return best;
}

}  // namespace

Eigen::MatrixXd basisPursuitCoefficients(const SampleRows& samples, const TaskControl& control) {
  const std::vector<double> penalties = triedPenalties();
  Eigen::Array3i last = Eigen::Array3i::Constant(int(penalties.size()) - 1);
  if (samples.rows.rows() > 1) last = bestPenalties(samples, penalties, control);
  const Lasso lasso(samples.rows);
  Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(samples.rows.cols(), 3);
  for (Eigen::Index channel = 0; channel < 3; ++channel) {
    const double largest = lasso.largestPenalty(samples.values.col(channel));
    Eigen::VectorXd solution = coefficients.col(channel);
    for (int i = 0; i <= last[channel] && largest > 0; ++i)
      lasso.solve(samples.values.col(channel), penalties[std::size_t(i)] * largest, solution);
    coefficients.col(channel) = solution;
  }
  return coefficients;
}

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

/// A coefficient of a material may exceed those of the training set by this factor.
constexpr double mostOfTraining = 10;

void warnAbout(const SampleRows& samples, Reconstruction& result) {
  const auto count = std::size_t(samples.rows.rows());
  if (count < samples.readings)
    result.warnings.push_back(std::to_string(samples.readings) + " readings are at only " + std::to_string(count) +
                              (count == 1 ? " direction" : " directions") +
                              " that differ; readings of one direction count as one, their mean.");
  const Eigen::Index components = std::min(samples.rows.rows(), samples.rows.cols());
  if (components < 2) return;
  const Eigen::VectorXd values = thinSvd(samples.rows.leftCols(components)).singularValues;
  if (const double condition = values[0] / values[components - 1]; !(condition <= maxReliableCondition))
    result.warnings.push_back("The directions of the samples are nearly dependent (condition number " +
                              (std::isfinite(condition) ? numberText(float(condition)) : std::string("infinite")) +
                              "): errors of the readings may be amplified. Choose directions that are farther apart.");
}

}  // namespace

ReconstructionOptions publishedReconstruction() {
  return {.ridge = publishedRidge, .equalNoise = true, .componentsAsSamples = true};
}

Reconstruction reconstructCode(const PrincipalComponents& basis, const SamplingPlan& plan, const MeasuredValues& values,
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
    coefficients = solveLocalRidge(basis, samples, options, result, control);
  else if (options.method == ReconstructionMethod::basisPursuit)
    coefficients = basisPursuitCoefficients(samples, control);
  else if (options.method != ReconstructionMethod::sparse)
    coefficients = solveRidge(basis, samples, options, result, control);
  else
    coefficients =
        sparseCoefficients(samples, options.atoms, control, mostOfTraining * basis.svd.v.cwiseAbs().maxCoeff());
  warnAbout(samples, result);
  result.code = codeOf(basis, coefficients);
  return result;
}

Reconstruction reconstruct(const PrincipalComponents& basis, const SamplingPlan& plan, const MeasuredValues& values,
                           const ReconstructionOptions& options, const TaskControl& control) {
  Reconstruction result = reconstructCode(basis, plan, values, options, control.between(0, 0.5));
  result.table = dictionary::decode(basis, result.code, control.between(0.5, 1), &result.cappedCount);
  return result;
}

}  // namespace gonio::acquisition
