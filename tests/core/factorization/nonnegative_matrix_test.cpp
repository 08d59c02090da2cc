// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/nonnegative_matrix.h"

#include <QTest>
#include <cmath>

#include "tests/core/factorization/factorization_test_support.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/test_program.h"

namespace nonnegative_matrix_test {
using namespace gonio;
using namespace gonio::factorization;
using namespace gonio::factorization::test_support;

class NonnegativeMatrixTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void factorsAreNonNegativeAndTheResidualFalls() {
    const Eigen::MatrixXd y = randomMatrix(12, 15, 1, true);
    const NonnegativeFactors f = factorizeNonnegative(y, 4, {.tolerance = 0});
    QVERIFY(f.left.minCoeff() >= 0 && f.right.minCoeff() >= 0);
    for (std::size_t i = 1; i < f.residuals.size(); ++i) QVERIFY(f.residuals[i] <= f.residuals[i - 1] * (1 + 1e-14));
    QVERIFY(std::abs(f.residuals.back() - (y - f.left * f.right).norm()) < 1e-12);
  }

  /// The best rank-1 approximation of a positive matrix is positive: the leading singular pair.
  void rankOneIsTheLeadingSingularPair() {
    const Eigen::MatrixXd y = randomMatrix(9, 7, 2, true);
    const Eigen::VectorXd singular = test::singularValues(y);
    const NonnegativeFactors f = factorizeNonnegative(y, 1, {.tolerance = 1e-15});
    QVERIFY(std::abs(f.residuals.back() - singular.tail(6).norm()) < 1e-9);
  }

  void findsSeparableData() {
    const Eigen::MatrixXd y = randomMatrix(20, 2, 3, true) * randomMatrix(2, 25, 4, true);
    const NonnegativeFactors f = factorizeNonnegative(y, 2, {.maxIterations = 20000, .tolerance = 1e-12});
    QVERIFY2(f.residuals.back() < 1e-3 * y.norm(), QByteArray::number(f.residuals.back() / y.norm()));
  }

  void negativeEntriesCountAsZero() {
    Eigen::MatrixXd y = randomMatrix(6, 6, 5, true), cut = y;
    y(2, 3) = -4;
    cut(2, 3) = 0;
    QVERIFY(factorizeNonnegative(y, 2).left == factorizeNonnegative(cut, 2).left);
  }

  void hardCase18Zero() {
    const NonnegativeFactors f = factorizeNonnegative(Eigen::MatrixXd::Zero(4, 5), 2);
    QVERIFY(f.left.allFinite() && f.right.allFinite());
    QCOMPARE(f.residuals.back(), 0.0);
  }

  void theSameSeedGivesTheSameFactors() {
    const Eigen::MatrixXd y = randomMatrix(6, 8, 6, true);
    QVERIFY(factorizeNonnegative(y, 2).right == factorizeNonnegative(y, 2).right);
    QVERIFY(factorizeNonnegative(y, 2, {.seed = 2}).right != factorizeNonnegative(y, 2).right);
  }
};

GONIO_TEST(NonnegativeMatrixTest)
}  // namespace nonnegative_matrix_test

#include "nonnegative_matrix_test.moc"
