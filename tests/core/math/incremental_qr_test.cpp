// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/decompositions.h"

#include <Eigen/Core>
#include <QTest>

#include "tests/support/linear_oracles.h"
#include "tests/support/random_matrix.h"

#include "tests/support/test_program.h"

namespace incremental_qr_test {
using namespace gonio;
using Eigen::MatrixXd, Eigen::VectorXd;
using gonio::test::randomMatrix;

double orthonormalityError(const IncrementalQr& qr) {
  return (qr.q().transpose() * qr.q() - MatrixXd::Identity(qr.size(), qr.size())).cwiseAbs().maxCoeff();
}

class IncrementalQrTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void productIsTheMatrix() {
    const MatrixXd a = randomMatrix(20, 12, 1);
    IncrementalQr qr(20, 12);
    for (int k = 0; k < 12; ++k) {
      QVERIFY(qr.append(a.col(k)));
      QCOMPARE(qr.size(), Eigen::Index(k + 1));
      QVERIFY((qr.q() * qr.r() - a.leftCols(k + 1)).norm() < 1e-13 * a.norm());
    }
    QVERIFY(orthonormalityError(qr) < 1e-14);
    QVERIFY(qr.r().isUpperTriangular(0));
  }

  /// Columns that differ by 1e-7 of their length: one pass of Gram-Schmidt would leave Q orthonormal to 1e-9 only.
  void nearlyCollinearColumnsStayOrthonormal() {
    const MatrixXd noise = randomMatrix(50, 8, 2);
    IncrementalQr qr(50, 8);
    for (int k = 0; k < 8; ++k) QVERIFY(qr.append(VectorXd::Ones(50) + 1e-7 * noise.col(k)));
    QVERIFY(orthonormalityError(qr) < 1e-14);
  }

  void solvesLeastSquares() {
    const MatrixXd a = randomMatrix(30, 7, 3);
    const VectorXd x = randomMatrix(30, 1, 4);
    IncrementalQr qr(30, 7);
    for (int k = 0; k < 7; ++k) qr.append(a.col(k));
    const VectorXd expected = test::leastSquares(a, x);
    QVERIFY((qr.solve(qr.q().transpose() * x) - expected).norm() < 1e-13 * expected.norm());
  }

  /// Zero columns, repeated ones, sums of others, and more columns than rows: refused, and nothing changes.
  void hardCase22ColumnsOfTheSpanAreRefused() {
    const MatrixXd a = randomMatrix(3, 4, 5);
    IncrementalQr qr(3, 4);
    QVERIFY(!qr.append(VectorXd::Zero(3)));
    QVERIFY(qr.append(a.col(0)) && qr.append(a.col(1)));
    QVERIFY(!qr.append(-5 * a.col(0)));
    QVERIFY(!qr.append(a.col(0) + 1e6 * a.col(1)));
    QCOMPARE(qr.size(), Eigen::Index(2));
    QVERIFY(qr.append(a.col(2)));
    QVERIFY(!qr.append(a.col(3)));
    QVERIFY((qr.q() * qr.r() - a.leftCols(3)).norm() < 1e-14 * a.norm());
  }

  void tinyAndHugeColumns() {
    const MatrixXd a = randomMatrix(6, 3, 6);
    IncrementalQr qr(6, 3);
    QVERIFY(qr.append(1e-200 * a.col(0)) && qr.append(1e200 * a.col(1)) && qr.append(a.col(2)));
    QVERIFY(orthonormalityError(qr) < 1e-14);
    QVERIFY((qr.q() * (qr.r().col(1) * 1e-200) - a.col(1)).norm() < 1e-13);
  }
};

GONIO_TEST(IncrementalQrTest)
}  // namespace incremental_qr_test

#include "incremental_qr_test.moc"
