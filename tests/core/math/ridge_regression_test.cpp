// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/regression.h"

#include <QTest>
#include <limits>

#include "tests/support/linear_oracles.h"
#include "tests/support/random_matrix.h"

#include "tests/support/test_program.h"

namespace ridge_regression_test {
using namespace gonio;
using Eigen::MatrixXd;
using gonio::test::randomMatrix;

MatrixXd identity(Eigen::Index size) { return MatrixXd::Identity(size, size); }

/// By the textbook, well conditioned where the ridge is not small.
MatrixXd normalEquations(const MatrixXd& a, const MatrixXd& b, double ridge) {
  return test::inverse(a.transpose() * a + ridge * identity(a.cols())) * a.transpose() * b;
}

MatrixXd without(const MatrixXd& matrix, Eigen::Index row) {
  MatrixXd result(matrix.rows() - 1, matrix.cols());
  result << matrix.topRows(row), matrix.bottomRows(matrix.rows() - 1 - row);
  return result;
}

double relative(const MatrixXd& found, const MatrixXd& expected) { return (found - expected).norm() / expected.norm(); }

/// Fewer rows than columns, as many, more.
const std::pair<Eigen::Index, Eigen::Index> shapes[] = {{5, 9}, {7, 7}, {12, 6}};

class RidgeRegressionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void equalsNormalEquations() {
    for (const auto& [rows, columns] : shapes)
      for (const double ridge : {0.1, 1.0, 40.0, 1e4}) {
        const MatrixXd a = randomMatrix(rows, columns, 1), b = randomMatrix(rows, 3, 2);
        QVERIFY(relative(RidgeRegression(a, b).coefficients(ridge), normalEquations(a, b, ridge)) < 1e-12);
      }
  }

  /// Fewer rows than columns, as many, more: without a ridge the solution of least norm, with an infinite one 0.
  void limits() {
    for (const auto& [rows, columns] : shapes) {
      const MatrixXd a = randomMatrix(rows, columns, 3), b = randomMatrix(rows, 3, 4);
      const RidgeRegression regression(a, b);
      const MatrixXd least = test::leastSquares(a, b);
      QVERIFY(relative(regression.coefficients(0), least) < 1e-11);
      QVERIFY(relative(regression.coefficients(1e-12), least) < 1e-9);
      QVERIFY(regression.coefficients(std::numeric_limits<double>::infinity()).isZero(0));
      QVERIFY(regression.coefficients(1e30).norm() < 1e-25);
    }
  }

  /// Rows that stand twice or are 0: the least norm, with any small ridge nearly so, never a number that is none.
  void singular() {
    MatrixXd a = randomMatrix(6, 4, 5);
    a.col(3) = a.col(0);
    a.row(5).setZero();
    const MatrixXd b = randomMatrix(6, 3, 6);
    const RidgeRegression regression(a, b);
    const MatrixXd least = test::leastSquares(a, b);
    QVERIFY(relative(regression.coefficients(0), least) < 1e-12);
    QVERIFY(relative(regression.coefficients(1e-30), least) < 1e-12);
    QVERIFY(regression.leaveOneOut(1e-30).allFinite());
    const RidgeRegression nothing(MatrixXd::Zero(3, 2), b.topRows(3));
    QVERIFY(nothing.coefficients(0).isZero(0));
    QVERIFY((nothing.leaveOneOut(1) - b.topRows(3)).norm() < 1e-12);
    QCOMPARE(nothing.leaveOneOutRidge(40), 40.0);
  }

  /// Each row against what the textbook predicts from all others.
  void leaveOneOutEqualsLeavingOut() {
    for (const auto& [rows, columns] : shapes)
      for (const double ridge : {1e-3, 1.0, 40.0}) {
        const MatrixXd a = randomMatrix(rows, columns, 7), b = randomMatrix(rows, 3, 8);
        const MatrixXd found = RidgeRegression(a, b).leaveOneOut(ridge);
        for (Eigen::Index row = 0; row < rows; ++row) {
          const MatrixXd left = b.row(row) - a.row(row) * normalEquations(without(a, row), without(b, row), ridge);
          QVERIFY((found.row(row) - left).norm() < 1e-8 * b.norm());
        }
      }
  }

  /// The ridge that is chosen predicts rows that are left out better than any other of a fine scale, to its steps; it
  /// grows with the noise.
  void leaveOneOutRidge() {
    const MatrixXd a = randomMatrix(30, 12, 9), truth = randomMatrix(12, 3, 10), noise = randomMatrix(30, 3, 11);
    double last = 0;
    for (const double size : {0.1, 1.0, 8.0}) {
      const RidgeRegression regression(a, a * truth + size * noise);
      const double ridge = regression.leaveOneOutRidge(40), error = regression.leaveOneOut(ridge).squaredNorm();
      for (double other = 1e-4; other < 1e4; other *= 1.07)
        QVERIFY(regression.leaveOneOut(other).squaredNorm() > 0.999 * error);
      QVERIFY(ridge > last);
      last = ridge;
    }
  }

  /// No other row predicts the only one; and where rows have no information on each other every ridge has the same
  /// error, so that the largest is taken whatever rounding says.
  void leaveOneOutRidgeThatNothingTells() {
    for (unsigned seed = 16; seed < 26; ++seed)
      QCOMPARE(RidgeRegression(randomMatrix(1, 5, seed), randomMatrix(1, 3, seed)).leaveOneOutRidge(40), 40.0);
    for (unsigned seed = 26; seed < 36; ++seed) {
      const MatrixXd rotation = test::orthonormalised(randomMatrix(5, 5, seed)), a = 3.7 * rotation;
      const double ridge = RidgeRegression(a, randomMatrix(5, 3, seed + 10)).leaveOneOutRidge(40);
      QVERIFY2(std::abs(ridge / (1e3 * 3.7 * 3.7) - 1) < 1e-9, qPrintable(QString::number(ridge)));
    }
  }

  void posteriorEqualsInverse() {
    for (const auto& [rows, columns] : shapes)
      for (const double ridge : {1e-2, 1.0, 40.0}) {
        const MatrixXd a = randomMatrix(rows, columns, 12), b = randomMatrix(rows, 3, 13);
        const RidgeRegression regression(a, b);
        const MatrixXd factor = regression.posteriorFactor(ridge);
        const MatrixXd expected = ridge * test::inverse(a.transpose() * a + ridge * identity(columns));
        QVERIFY(relative(factor * factor.transpose(), expected) < 1e-11);
        const MatrixXd energy = b.transpose() * test::inverse(a * a.transpose() + ridge * identity(rows)) * b;
        QVERIFY(std::abs(regression.weightedEnergy(ridge) / energy.trace() - 1) < 1e-11);
      }
    const RidgeRegression regression(randomMatrix(3, 5, 14), randomMatrix(3, 1, 15));
    QVERIFY(regression.posteriorFactor(std::numeric_limits<double>::infinity()).isIdentity(1e-15));
    // Without noise, three directions of five are known.
    QVERIFY(std::abs(regression.posteriorFactor(0).squaredNorm() - 2) < 1e-12);
  }
};

GONIO_TEST(RidgeRegressionTest)
}  // namespace ridge_regression_test

#include "ridge_regression_test.moc"
