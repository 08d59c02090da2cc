// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/regression.h"

#include <Eigen/QR>
#include <QTest>
#include <random>

#include "tests/support/test_program.h"

namespace lasso_test {
using namespace gonio;
using Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd randomMatrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); });
}

class LassoTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Orthonormal columns: each coefficient moves toward 0 by lambda (closed form).
  void softThreshold() {
    const MatrixXd q = randomMatrix(12, 5, 1).householderQr().householderQ() * MatrixXd::Identity(12, 5);
    const VectorXd b = randomMatrix(12, 1, 2);
    const VectorXd projected = q.transpose() * b;
    const double lambda = 0.4;
    VectorXd found = VectorXd::Zero(5);
    Lasso(q).solve(b, lambda, found);
    for (Eigen::Index i = 0; i < 5; ++i) {
      const double expected = std::copysign(std::max(0.0, std::abs(projected[i]) - lambda), projected[i]);
      QVERIFY(std::abs(found[i] - expected) < 1e-8);
    }
  }

  /// The conditions of the minimum (Karush, Kuhn and Tucker): A^T (b - A c) is lambda sign(c) where c is not 0, and at
  /// most lambda elsewhere. More rows than columns, and fewer.
  void conditionsOfTheMinimum() {
    for (const auto& [rows, columns] : {std::pair(30, 10), std::pair(10, 40)})
      for (unsigned seed = 1; seed <= 5; ++seed) {
        const MatrixXd a = randomMatrix(rows, columns, seed);
        const VectorXd b = randomMatrix(rows, 1, 100 + seed);
        const Lasso lasso(a);
        for (const double fraction : {0.5, 0.1, 0.01}) {
          const double lambda = fraction * lasso.largestPenalty(b);
          VectorXd c = VectorXd::Zero(columns);
          lasso.solve(b, lambda, c);
          const VectorXd gradient = a.transpose() * (b - a * c);
          for (Eigen::Index i = 0; i < columns; ++i)
            QVERIFY(c[i] != 0 ? std::abs(gradient[i] - std::copysign(lambda, c[i])) < 1e-5
                              : std::abs(gradient[i]) < lambda + 1e-5);
          QVERIFY(!c.isZero(0));
        }
        VectorXd c = VectorXd::Ones(columns);
        lasso.solve(b, lasso.largestPenalty(b) * 1.000001, c);
        QVERIFY(c.cwiseAbs().maxCoeff() < 1e-8);
      }
  }

  void columnsOfZero() {
    MatrixXd a = randomMatrix(6, 3, 9);
    a.col(1).setZero();
    VectorXd c = VectorXd::Zero(3);
    Lasso(a).solve(a.col(0), 1e-6, c);
    QVERIFY(c[1] == 0 && std::abs(c[0] - 1) < 1e-5);
    QCOMPARE(Lasso(MatrixXd(4, 0)).largestPenalty(VectorXd::Ones(4)), 0.0);
  }
};

GONIO_TEST(LassoTest)
}  // namespace lasso_test

#include "lasso_test.moc"
