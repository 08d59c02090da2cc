// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/local_ridge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/math/decompositions.h"
#include "core/math/parallel.h"

namespace gonio::acquisition {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array<double, 5> bandwidths{0.11, 0.22, 0.44, 0.89, infinity};
constexpr double minWeight = 0.005;
/// s^2, variances of mapped values.
constexpr std::array<double, 15> noises{1e-5, 3.16e-5, 1e-4, 3.16e-4, 1e-3, 3.16e-3, 1e-2, 3.16e-2,
                                        1e-1, 3.16e-1, 1,    3.16,    10,   31.6,    100};
constexpr Index maxGroups = 40;
constexpr Index channels = 3;

/// The part of the samples that predicts the others.
std::vector<Index> withoutGroup(Index samples, Index group, Index groups) {
  std::vector<Index> kept;
  for (Index i = 0; i < samples; ++i)
    if (i % groups != group) kept.push_back(i);
  return kept;
}

/// Probabilities of the training signals: weights with sum 1.
VectorXd probabilities(const VectorXd& distances, double bandwidth) {
  VectorXd weights = VectorXd::Ones(distances.size());
  if (std::isfinite(bandwidth))
    weights = (-(distances.array() - distances.minCoeff()) / (2 * bandwidth * bandwidth)).exp().max(minWeight);
  return weights / weights.sum();
}

class Regression {
 public:
  Regression(const SampleRows& samples, const MatrixXd& v)
      : samples_(samples), v_(v.leftCols(samples.rows.cols())), signals_(samples.rows * v_.transpose()) {
    const VectorXd variances = signals_.rowwise().squaredNorm() / double(signals_.cols()) + samples.knownNoise;
    inverseVariances_ = variances.unaryExpr([](double variance) { return variance > 0 ? 1 / variance : 0.0; });
  }

  /// Adds the squared errors of the predictions of one group of samples from the others: bandwidths x noises.
  void addErrors(Index group, Index groups, MatrixXd& errors) const {
    const std::vector<Index> kept = withoutGroup(samples_.values.rows(), group, groups);
    for (Index channel = 0; channel < channels; ++channel) {
      const VectorXd distances = distancesOf(kept, channel);
      for (std::size_t b = 0; b < bandwidths.size(); ++b) {
        const Local local(*this, kept, channel, probabilities(distances, bandwidths[b]));
        for (std::size_t n = 0; n < noises.size(); ++n) {
          const VectorXd columns = local.columns(noises[n]);
          for (Index left = group; left < samples_.values.rows(); left += groups)
            errors(Index(b), Index(n)) +=
                std::pow(samples_.values(left, channel) - local.mean[left] - local.factor.row(left).dot(columns), 2);
        }
      }
    }
  }

  /// Coefficients of one channel for each noise with a positive weight, times that weight.
  VectorXd coefficients(Index channel, std::size_t bandwidth, const VectorXd& noiseWeights) const {
    const Local local = all(channel, bandwidth);
    VectorXd combination = VectorXd::Zero(signals_.cols());
    for (Index n = 0; n < noiseWeights.size(); ++n)
      if (noiseWeights[n] > 0) combination += noiseWeights[n] * local.combination(noises[std::size_t(n)]);
    return v_.transpose() * combination;
  }

  /// How much each sample counts for the scale of the covariance: the fraction of its noise that is not known.
  VectorXd unknownFractions(double noise) const {
    return 1 - samples_.knownNoise.array() / (noise + samples_.variances.array());
  }

  /// The covariance of the coefficients of one channel given the samples. Adds to `energy` the squares of the channel's
  /// values relative to their predicted variance, times `counts`.
  MatrixXd posterior(Index channel, std::size_t bandwidth, double noise, const VectorXd& counts, double& energy) const {
    const Local local = all(channel, bandwidth);
    const MatrixXd centred = (v_.rowwise() - (local.weights.transpose() * v_).eval());
    const MatrixXd prior = centred.transpose() * local.weights.asDiagonal() * centred;
    const MatrixXd gain = prior * samples_.rows.transpose();  // components x samples
    MatrixXd variance = samples_.rows * gain;
    variance.diagonal() += samples_.variances + VectorXd::Constant(variance.rows(), noise);
    const VectorXd difference = counts.cwiseSqrt().cwiseProduct(samples_.values.col(channel) - local.mean);
    energy += difference.dot(solveSymmetric(variance, difference).col(0));
    return prior - gain * solveSymmetric(variance, gain.transpose());
  }

 private:
  /// The regression of one channel with given weights of the training signals. With the weighted mean subtracted, K =
  /// G G^T + variances is the covariance of the samples without s^2; its eigenvectors serve all s^2.
  struct Local {
    const Regression& of;
    VectorXd weights, mean, scaled;  ///< mean of the signals at all samples; scaled: eigenvectors^T difference
    MatrixXd factor;                 ///< G of all samples: weighted signals without the mean
    MatrixXd projected;              ///< eigenvectors^T G of the kept samples
    VectorXd values;                 ///< eigenvalues

    Local(const Regression& regression, const std::vector<Index>& kept, Index channel, const VectorXd& probability)
        : of(regression), weights(probability), mean(of.signals_ * probability) {
      factor = (of.signals_.colwise() - mean) * probability.cwiseSqrt().asDiagonal();
      const MatrixXd g = factor(kept, Eigen::all);
      MatrixXd covariance = g * g.transpose();
      covariance.diagonal() += of.samples_.variances(kept);
      const EigenBasis basis = eigenBasis(covariance);
      values = basis.values;
      projected = basis.vectors.transpose() * g;
      const VectorXd difference = of.samples_.values.col(channel) - mean;
      scaled = basis.vectors.transpose() * difference(kept);
    }

    /// Solution for the noise: combination of the columns of G.
    VectorXd columns(double noise) const {
      return projected.transpose() * (scaled.array() / (values.array() + noise)).matrix();
    }
    /// The same as a combination of the training signals.
    VectorXd combination(double noise) const {
      const VectorXd q = weights.cwiseSqrt().cwiseProduct(columns(noise));
      return weights * (1 - q.sum()) + q;
    }
  };

  VectorXd distancesOf(const std::vector<Index>& kept, Index channel) const {
    VectorXd distances = VectorXd::Zero(signals_.cols());
    for (const Index i : kept)
      distances +=
          inverseVariances_[i] * (signals_.row(i).transpose().array() - samples_.values(i, channel)).square().matrix();
    return distances / double(kept.size());
  }

  Local all(Index channel, std::size_t bandwidth) const {
    const std::vector<Index> kept = withoutGroup(samples_.values.rows(), -1, samples_.values.rows());
    return {*this, kept, channel, probabilities(distancesOf(kept, channel), bandwidths[bandwidth])};
  }

  const SampleRows& samples_;
  MatrixXd v_;
  MatrixXd signals_;  ///< of the training set at the samples: samples x signals
  VectorXd inverseVariances_;
};

/// Weights of the combinations, with sum 1; those below a thousandth are 0.
MatrixXd combinationWeights(const MatrixXd& errors, Index samples) {
  const double smallest = errors.minCoeff();
  MatrixXd weights = MatrixXd::Zero(errors.rows(), errors.cols());
  if (smallest > 0)
    weights = (-0.5 * double(samples) * (errors.array() / smallest).log()).exp();
  else
    weights = (errors.array() <= smallest).cast<double>();
  weights /= weights.sum();
  constexpr double negligible = 1e-3;
  weights = (weights.array() >= negligible).select(weights, 0);
  return weights / weights.sum();
}

/// F with F F^T = covariance.
MatrixXd factorOf(const MatrixXd& covariance) {
  const EigenBasis basis = eigenBasis(covariance);
  return basis.vectors * basis.values.cwiseSqrt().asDiagonal();
}

}  // namespace

LocalRidge localRidge(const SampleRows& samples, const Eigen::MatrixXd& v, bool uncertainty,
                      const TaskControl& control) {
  const Index count = samples.values.rows(), groups = std::min(count, maxGroups);
  const Regression regression(samples, v);
  std::vector<MatrixXd> errors(std::size_t(groups), MatrixXd::Zero(bandwidths.size(), noises.size()));
  parallelForBlocks(
      errors.size(), 1,
      [&](std::size_t group, std::size_t) { regression.addErrors(Index(group), groups, errors[group]); }, control);
  MatrixXd total = MatrixXd::Zero(bandwidths.size(), noises.size());
  for (const MatrixXd& one : errors) total += one;
  const MatrixXd weights = combinationWeights(total, count);

  LocalRidge result{.coefficients = MatrixXd::Zero(samples.rows.cols(), channels), .posteriorFactor = {}};
  for (Index channel = 0; channel < channels; ++channel)
    for (std::size_t b = 0; b < bandwidths.size(); ++b)
      if (const VectorXd of = weights.row(Index(b)); of.sum() > 0)
        result.coefficients.col(channel) += regression.coefficients(channel, b, of);
  Index bandwidth = 0, noise = 0;
  weights.maxCoeff(&bandwidth, &noise);
  result.ridge = noises[std::size_t(noise)] * double(v.rows());
  result.leaveOneOutError = std::sqrt(total(bandwidth, noise) / double(channels * count));
  if (!uncertainty) return result;
  MatrixXd covariance = MatrixXd::Zero(samples.rows.cols(), samples.rows.cols());
  const double variance = noises[std::size_t(noise)];
  const VectorXd counts = regression.unknownFractions(variance);
  double energy = 0;
  for (Index channel = 0; channel < channels; ++channel)
    covariance += regression.posterior(channel, std::size_t(bandwidth), variance, counts, energy) / channels;
  result.posteriorFactor = factorOf(covariance);
  result.scale = (1 + energy) / (1 + channels * counts.sum());
  return result;
}

}  // namespace gonio::acquisition
