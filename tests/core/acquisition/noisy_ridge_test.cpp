// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/reconstruction.h"

#include <QTest>
#include <cmath>
#include <limits>

#include "core/math/parallel.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/random_matrix.h"
#include "tests/support/test_program.h"

namespace noisy_ridge_test {
using namespace gonio;
using namespace gonio::acquisition;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using gonio::test::randomMatrix;

SampleRows randomSamples(Eigen::Index rows, Eigen::Index columns) {
  return {.positions = {}, .rows = randomMatrix(rows, columns, 1), .values = randomMatrix(rows, 3, 2), .variances = {}};
}

VectorXd randomNoise(Eigen::Index rows) { return 10 * randomMatrix(rows, 1, 3).cwiseAbs2(); }

SampleRows without(const SampleRows& samples, Eigen::Index row) {
  SampleRows left = samples;
  const Eigen::Index after = samples.rows.rows() - row - 1;
  left.rows.middleRows(row, after) = samples.rows.bottomRows(after);
  left.values.middleRows(row, after) = samples.values.bottomRows(after);
  left.rows.conservativeResize(samples.rows.rows() - 1, Eigen::NoChange);
  left.values.conservativeResize(samples.rows.rows() - 1, Eigen::NoChange);
  return left;
}

/// Q^T (Q Q^T + N)^-1 y.
MatrixXd byDefinition(const SampleRows& samples, const VectorXd& variances) {
  const MatrixXd covariance = samples.rows * samples.rows.transpose() + MatrixXd(variances.asDiagonal());
  return samples.rows.transpose() * test::inverse(covariance) * samples.values;
}

class NoisyRidgeTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void equalsItsDefinition() {
    for (const auto& [rows, columns] : {std::pair(8, 5), std::pair(5, 8)})
      for (const double ridge : {0.0, 0.5, 40.0}) {
        const SampleRows samples = randomSamples(rows, columns);
        const VectorXd noise = randomNoise(rows), variances = noise.array() + ridge;
        const NoisyRidge found(samples, noise, ridge);
        const MatrixXd expected = byDefinition(samples, variances);
        QVERIFY((found.coefficients() - expected).norm() < 1e-9 * expected.norm());
        const MatrixXd precision = samples.rows.transpose() * variances.cwiseInverse().asDiagonal() * samples.rows;
        const MatrixXd covariance = test::inverse(precision + MatrixXd::Identity(columns, columns));
        const MatrixXd factor = found.posteriorFactor();
        QVERIFY((factor * factor - covariance).norm() < 1e-9);
        const MatrixXd all = samples.rows * samples.rows.transpose() + MatrixXd(variances.asDiagonal());
        const double energy = (samples.values.transpose() * test::inverse(all) * samples.values).trace();
        QVERIFY(std::abs(found.weightedEnergy() / energy - 1) < 1e-9);
      }
  }

  void leaveOneOutEqualsLeavingOut() {
    const SampleRows samples = randomSamples(8, 5);
    const VectorXd noise = randomNoise(8);
    const MatrixXd found = NoisyRidge(samples, noise, 0.3).leaveOneOut();
    for (Eigen::Index row = 0; row < 8; ++row) {
      VectorXd variances(7);
      variances << noise.head(row), noise.tail(7 - row);
      variances.array() += 0.3;
      const MatrixXd c = byDefinition(without(samples, row), variances);
      QVERIFY((found.row(row) - (samples.values.row(row) - samples.rows.row(row) * c)).norm() < 1e-9);
    }
  }

  /// The least of the sums by definition, and the same for any number of threads; without noise that of
  /// RidgeRegression.
  void chosenRidge() {
    const SampleRows samples = randomSamples(12, 6);
    const VectorXd noise = randomNoise(12);
    const auto sumOf = [&](double ridge) {
      const MatrixXd left = NoisyRidge(samples, noise, ridge).leaveOneOut();
      return (left.rowwise().squaredNorm().array() / (publishedRidge + noise.array())).sum();
    };
    const double found = leaveOneOutRidge(samples, noise);
    const std::vector<double> tried = RidgeRegression(samples.rows, samples.values).triedRidges();
    QCOMPARE(tried.size(), std::size_t(101));
    for (const double other : tried) QVERIFY(sumOf(found) <= sumOf(other) * (1 + 1e-8));
    const ThreadLimit limit(1);
    QCOMPARE(leaveOneOutRidge(samples, noise), found);
    QCOMPARE(leaveOneOutRidge(samples, VectorXd::Zero(12)),
             RidgeRegression(samples.rows, samples.values).leaveOneOutRidge(publishedRidge));
  }

  /// Without a ridge samples without noise hold exactly, the others decide the rest; an infinite ridge gives no
  /// information.
  void limits() {
    const SampleRows samples = randomSamples(8, 5);
    VectorXd noise = randomNoise(8);
    noise.head(2).setZero();
    const MatrixXd c = NoisyRidge(samples, noise, 0).coefficients();
    QVERIFY((samples.rows.topRows(2) * c - samples.values.topRows(2)).norm() < 1e-5);
    const MatrixXd near = NoisyRidge(samples, noise, 1e-7).coefficients();
    QVERIFY((c - near).norm() < 1e-4 * c.norm());
    const NoisyRidge endless(samples, noise, std::numeric_limits<double>::infinity());
    QVERIFY(endless.coefficients().isZero(0) && endless.posteriorFactor().isIdentity(1e-15));
  }
};

GONIO_TEST(NoisyRidgeTest)
}  // namespace noisy_ridge_test

#include "noisy_ridge_test.moc"
