// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/reconstruction.h"

#include <Eigen/QR>
#include <QTest>
#include <limits>
#include <random>

#include "core/math/matching_pursuit.h"
#include "tests/support/test_program.h"

namespace sparse_samples_test {
using namespace gonio;
using namespace gonio::acquisition;
using Eigen::MatrixXd;

/// Rows of falling size and values of three components with some noise.
SampleRows randomSamples(Eigen::Index count, Eigen::Index components, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(generator); };
  SampleRows samples;
  samples.rows = MatrixXd::NullaryExpr(count, components, draw);
  for (Eigen::Index k = 0; k < components; ++k) samples.rows.col(k) /= double(k + 1);
  samples.values = samples.rows.leftCols(3) * MatrixXd::NullaryExpr(3, 3, draw) * 4;
  samples.values += 0.3 * MatrixXd::NullaryExpr(count, 3, draw);
  return samples;
}

Eigen::VectorXd pursue(const MatrixXd& rows, const Eigen::VectorXd& signal, int steps) {
  const PursuitResult found = orthogonalMatchingPursuit(AtomSet(rows), signal, {.steps = steps});
  Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(rows.cols());
  for (std::size_t a = 0; a < found.atoms.size(); ++a) coefficients[found.atoms[a]] = found.coefficients[a];
  return coefficients;
}

/// Each sample left out, each number of atoms, a pursuit of its own.
Eigen::VectorXd byBruteForce(const SampleRows& samples, Eigen::Index channel) {
  const Eigen::Index count = samples.rows.rows();
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int atoms = 1; atoms <= count / 2; ++atoms) {
    double error = 0;
    for (Eigen::Index out = 0; out < count; ++out) {
      MatrixXd rows = samples.rows;
      Eigen::VectorXd values = samples.values.col(channel);
      // A row of 0 has no information for a pursuit.
      rows.row(out).setZero();
      values[out] = 0;
      const double predicted = samples.rows.row(out).dot(pursue(rows, values, atoms));
      error += (samples.values(out, channel) - predicted) * (samples.values(out, channel) - predicted);
    }
    if (error < least) {
      least = error;
      best = atoms;
    }
  }
  return pursue(samples.rows, samples.values.col(channel), best);
}

class SparseSamplesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Fewer components than half the samples, as many as samples, more.
  void equalsLeavingOut() {
    for (const auto& [count, components] : {std::pair(20, 6), std::pair(14, 14), std::pair(9, 30)})
      for (unsigned seed = 1; seed <= 4; ++seed) {
        const SampleRows samples = randomSamples(count, components, seed);
        const MatrixXd found = sparseCoefficients(samples, 0);
        for (Eigen::Index channel = 0; channel < 3; ++channel) {
          const Eigen::VectorXd expected = byBruteForce(samples, channel);
          QVERIFY((found.col(channel) - expected).norm() < 1e-10 * expected.norm());
        }
      }
  }

  /// Values that few atoms explain wholly end a pursuit early; values of 0 need none.
  void pursuitsThatEndEarly() {
    SampleRows samples = randomSamples(12, 20, 5);
    samples.values = samples.rows.leftCols(1) * Eigen::RowVector3d(1, 0, -2);
    const MatrixXd found = sparseCoefficients(samples, 0);
    QVERIFY(std::abs(found(0, 0) - 1) < 1e-10 && std::abs(found(0, 2) + 2) < 1e-10 && found.col(1).isZero(0));
  }

  /// Fewer samples than components: of all coefficients that explain the values, those with the smallest sum of
  /// absolute values are the few that made them.
  void basisPursuitFindsFewComponents() {
    SampleRows samples = randomSamples(14, 30, 7);
    samples.rows = samples.rows * Eigen::VectorXd::LinSpaced(30, 1, 30).asDiagonal();  // of equal size
    MatrixXd truth = MatrixXd::Zero(30, 3);
    truth(2, 0) = 1;
    truth(17, 0) = -2;
    truth(25, 2) = 0.5;
    samples.values = samples.rows * truth;
    const MatrixXd found = basisPursuitCoefficients(samples);
    QVERIFY((found - truth).cwiseAbs().maxCoeff() < 1e-3);
    QVERIFY(found.col(1).isZero(0));
    // The least-norm solution, which explains the values too, has another sum.
    const Eigen::VectorXd leastNorm = samples.rows.completeOrthogonalDecomposition().solve(samples.values.col(0));
    QVERIFY(leastNorm.lpNorm<1>() > 1.2 * found.col(0).lpNorm<1>());
  }

  /// Noise: the penalty that predicts left-out samples is neither 0 nor the one that sets all to 0.
  void basisPursuitOfNoise() {
    const SampleRows samples = randomSamples(40, 30, 8);
    const MatrixXd found = basisPursuitCoefficients(samples);
    QVERIFY(!found.isZero(1e-3));
    QVERIFY((samples.rows * found - samples.values).norm() > 0.2 * samples.values.norm() / 10);
    QCOMPARE(basisPursuitCoefficients(samples), found);
  }

  void canBeStopped() {
    std::stop_source source;
    int reports = 0;
    const TaskControl control{source.get_token(), [&](double) {
                                ++reports;
                                source.request_stop();
                              }};
    QVERIFY_EXCEPTION_THROWN(sparseCoefficients(randomSamples(20, 20, 6), 0, control), Cancelled);
    QCOMPARE(reports, 1);
    QVERIFY_EXCEPTION_THROWN(sparseCoefficients(randomSamples(20, 20, 6), 3, control), Cancelled);
    QVERIFY_EXCEPTION_THROWN(basisPursuitCoefficients(randomSamples(20, 20, 6), control), Cancelled);
  }
};

GONIO_TEST(SparseSamplesTest)
}  // namespace sparse_samples_test

#include "sparse_samples_test.moc"
