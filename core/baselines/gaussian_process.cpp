// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/gaussian_process.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/brdf/brdf.h"
#include "core/brdf/data_transform.h"
#include "core/math/decompositions.h"

namespace gonio::baselines {

namespace {

using Eigen::Index;
using Points = Eigen::Matrix<double, 3, Eigen::Dynamic>;
using Values = Eigen::Matrix<double, Eigen::Dynamic, 3>;

constexpr double noiseVariance = 1e-4;  ///< relative to the variance of the signal
constexpr Index likelihoodSamples = 300;

template <typename Array>
auto matern(const Array& squaredDistances) {
  const auto scaled = (3 * squaredDistances).sqrt().eval();
  return ((1 + scaled) * (-scaled).exp()).eval();
}

/// Covariances of all points of `a` (rows) and `b` (columns), both divided by the lengths.
Eigen::MatrixXd covariance(const Points& a, const Points& b) {
  Eigen::MatrixXd result(a.cols(), b.cols());
  for (Index j = 0; j < b.cols(); ++j)
    result.col(j) = matern((a.colwise() - b.col(j)).colwise().squaredNorm().transpose().array());
  return result;
}

struct Observations {
  Points points;
  Values values;  ///< ln(1 + rho) less the mean
  Eigen::RowVector3d mean;
};

Observations observationsOf(const factorization::HalfDifferenceSamples& s) {
  std::vector<Eigen::Vector3d> points, values;
  const factorization::HalfDifferenceAxes& axes = s.axes;
  for (std::size_t h = 0; h < axes.thetaH.size(); ++h)
    for (std::size_t d = 0; d < axes.thetaD.size(); ++d)
      for (std::size_t p = 0; p < axes.phiD.size(); ++p) {
        const std::size_t i = axes.index(h, d, p);
        if (!s.valid[i]) continue;
        points.push_back(gaussianPoint({axes.thetaH[h], axes.thetaD[d], axes.phiD[p]}));
        values.emplace_back(std::log1p(s.values[i].x), std::log1p(s.values[i].y), std::log1p(s.values[i].z));
      }
  const auto count = Index(points.size());
  Observations all{Points(3, count), Values(count, 3), Eigen::RowVector3d::Zero()};
  for (Index i = 0; i < count; ++i) {
    all.points.col(i) = points[std::size_t(i)];
    all.values.row(i) = values[std::size_t(i)].transpose();
  }
  if (count > 0) all.mean = all.values.colwise().mean();
  all.values.rowwise() -= all.mean;
  return all;
}

/// The logarithm of the marginal likelihood, less a constant, with the best variance of the signal in each channel.
double logLikelihood(const Points& points, const Values& values, const Eigen::Vector3d& lengths) {
  const Points scaled = lengths.cwiseInverse().asDiagonal() * points;
  Eigen::MatrixXd k = covariance(scaled, scaled);
  k.diagonal().array() += noiseVariance;
  const Eigen::LLT<Eigen::MatrixXd> cholesky(k);
  const Values solved = cholesky.solve(values);
  const double logDeterminant = 2 * cholesky.matrixLLT().diagonal().array().log().sum(), n = double(points.cols());
  double sum = 0;
  for (int c = 0; c < 3; ++c) {
    const double energy = values.col(c).dot(solved.col(c));
    if (energy > 0) sum -= 0.5 * (n * std::log(energy / n) + logDeterminant);
  }
  return sum;
}

/// Coordinate search, each length by factors of 2, then of sqrt(2).
Eigen::Vector3d likelyLengths(const Observations& all, const TaskControl& control) {
  const Index count = std::min(likelihoodSamples, all.points.cols());
  Points points(3, count);
  Values values(count, 3);
  for (Index i = 0; i < count; ++i) {
    const Index from = i * all.points.cols() / count;
    points.col(i) = all.points.col(from);
    values.row(i) = all.values.row(from);
  }
  Eigen::Vector3d lengths(0.3, 0.5, 0.5);
  double best = logLikelihood(points, values, lengths);
  for (const double factor : {2.0, 2.0, std::sqrt(2.0)})
    for (int axis = 0; axis < 3; ++axis)
      for (const double step : {factor, 1 / factor})
        for (;;) {
          control.throwIfStopped();
          Eigen::Vector3d tried = lengths;
          tried[axis] = std::clamp(tried[axis] * step, 0.02, 20.0);
          const double likelihood = logLikelihood(points, values, tried);
          if (!(likelihood > best)) break;
          best = likelihood;
          lengths = tried;
        }
  return lengths;
}

/// The points of largest posterior variance in turn. @param points divided by the lengths.
Points chooseNodes(const Points& points, Index count, const TaskControl& control) {
  count = std::min(count, points.cols());
  Eigen::VectorXd variance = Eigen::VectorXd::Ones(points.cols());
  Eigen::MatrixXd factor(points.cols(), count);
  Points nodes(3, count);
  for (Index k = 0; k < count; ++k) {
    control.throwIfStopped();
    Index chosen = 0;
    const double largest = variance.maxCoeff(&chosen);
    if (!(largest > 1e-9)) return nodes.leftCols(k);
    nodes.col(k) = points.col(chosen);
    factor.col(k) = covariance(points, points.col(chosen));
    if (k > 0) factor.col(k) -= factor.leftCols(k) * factor.row(chosen).head(k).transpose();
    factor.col(k) /= std::sqrt(largest);
    variance = (variance - factor.col(k).cwiseAbs2()).cwiseMax(0.0);
    variance[chosen] = 0;
  }
  return nodes;
}

}  // namespace

int gaussianNodes(std::size_t byteBudget) {
  constexpr std::size_t shared = 6 * sizeof(float), perNode = 6 * sizeof(float);
  return int(std::clamp(byteBudget < shared ? 0 : (byteBudget - shared) / perNode, std::size_t(1),
                        std::size_t(maxGaussianNodes)));
}

Eigen::Vector3d gaussianPoint(const HalfDifference& at) {
  const double sine = std::sin(at.phiD);
  return {std::sqrt(std::max(0.0, at.thetaH) / halfPi), at.thetaD / halfPi,
          std::sin(at.thetaH) * std::sin(at.thetaD) * sine * sine};
}

factorization::HalfDifferenceAxes gaussianAxes() { return factorization::makeHalfDifferenceAxes(45, 30, 7); }

GaussianProcess fitGaussianProcess(const factorization::HalfDifferenceSamples& samples, int nodes,
                                   const TaskControl& control) {
  const Observations all = observationsOf(samples);
  if (all.points.cols() == 0) return {{}, {}, Eigen::Vector3f::Ones(), Eigen::Vector3f::Zero()};
  const Eigen::Vector3d lengths = likelyLengths(all, control);
  const Points scaled = lengths.cwiseInverse().asDiagonal() * all.points;
  const Points chosen = chooseNodes(scaled, nodes, control);
  const Eigen::MatrixXd cross = covariance(chosen, scaled);
  Eigen::MatrixXd normal = noiseVariance * covariance(chosen, chosen);
  normal.noalias() += cross * cross.transpose();
  normal.diagonal().array() += 1e-10 * normal.trace() / double(normal.rows());
  const Eigen::MatrixXd weights = solveSymmetric(normal, cross * all.values);
  return {chosen.cast<float>(), weights.transpose().cast<float>(), lengths.cast<float>(),
          all.mean.transpose().cast<float>()};
}

std::shared_ptr<const Brdf> makeGaussianProcessBrdf(GaussianProcess process) {
  return makePairwiseBrdf([process = std::move(process)](const Direction& wi, const Direction& wo) {
    const HalfDifference at = toHalfDifference(wi, wo);
    if (!at.valid) return Rgb(0);
    Eigen::Vector3f y = process.mean;
    if (process.nodes.cols() > 0) {
      const Eigen::Vector3f point = gaussianPoint(at).cast<float>().cwiseQuotient(process.lengths);
      const Eigen::ArrayXf squares = (process.nodes.colwise() - point).colwise().squaredNorm().transpose();
      y += process.weights * matern(squares).matrix();
    }
    Rgb value;
    for (int c = 0; c < 3; ++c) value[c] = std::clamp(std::expm1(double(y[c])), 0.0, double(maxBrdfValue));
    return value;
  });
}

}  // namespace gonio::baselines
