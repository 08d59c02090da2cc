// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/noisy_ridge.h"

#include <cmath>

#include "core/acquisition/reconstruction.h"
#include "core/math/parallel.h"

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

/// Of 1 where nothing differs, an endless ridge too.
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

}  // namespace gonio::acquisition
