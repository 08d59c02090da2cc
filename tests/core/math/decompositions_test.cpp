// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/decompositions.h"

#include <QTest>
#include <algorithm>
#include <cmath>

#include "tests/support/linear_oracles.h"
#include "tests/support/random_matrix.h"
#include "tests/support/test_program.h"

namespace decompositions_test {
using namespace gonio;
using Eigen::MatrixXd, Eigen::VectorXd;
using gonio::test::randomMatrix;

double departureFromOrthonormal(const MatrixXd& columns) {
  return (columns.transpose() * columns - MatrixXd::Identity(columns.cols(), columns.cols())).norm();
}

/// The first entry of at least half the largest absolute value.
double firstLargeEntry(const Eigen::VectorXd& vector) {
  const double significant = vector.cwiseAbs().maxCoeff() / 2;
  return *std::find_if(vector.begin(), vector.end(), [&](double entry) { return std::abs(entry) >= significant; });
}

class DecompositionsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void eigenvectorsOfAKnownMatrix() {
    MatrixXd m(2, 2);
    m << 2, 1, 1, 2;
    const EigenBasis basis = eigenBasis(m);
    QVERIFY(std::abs(basis.values[0] - 3) < 1e-15 && std::abs(basis.values[1] - 1) < 1e-15);
    QVERIFY((basis.vectors.col(0) - Eigen::Vector2d(1, 1) / std::sqrt(2.0)).norm() < 1e-15);
  }

  void eigenvectorsRebuildADeficientMatrix() {
    const MatrixXd half = randomMatrix(9, 4, 7), gram = half * half.transpose();
    const EigenBasis basis = eigenBasis(gram);
    QVERIFY(basis.values.minCoeff() >= 0);
    QVERIFY(departureFromOrthonormal(basis.vectors) < 1e-13);
    QVERIFY((basis.vectors * basis.values.asDiagonal() * basis.vectors.transpose() - gram).norm() <
            1e-13 * gram.norm());
    for (int c = 0; c < 9; ++c) {
      QVERIFY(c == 0 || basis.values[c] <= basis.values[c - 1]);
      QVERIFY(firstLargeEntry(basis.vectors.col(c)) > 0);
    }
    // Entries of equal absolute value: rounding must not decide.
    const EigenBasis tied = eigenBasis((MatrixXd(2, 2) << 2, -1, -1, 2).finished());
    QVERIFY(tied.vectors(0, 0) > 0 && tied.vectors(0, 1) > 0);
  }

  void singularVectorsRebuildTallAndWide() {
    for (const MatrixXd& m :
         {randomMatrix(40, 7, 7), MatrixXd(randomMatrix(40, 7, 7).transpose()), randomMatrix(30, 30, 7)}) {
      const ThinSvd svd = thinSvd(m);
      QCOMPARE(svd.u.cols(), std::min(m.rows(), m.cols()));
      QVERIFY(departureFromOrthonormal(svd.u) < 1e-13 && departureFromOrthonormal(svd.v) < 1e-13);
      QVERIFY((svd.u * svd.singularValues.asDiagonal() * svd.v.transpose() - m).norm() < 1e-13 * m.norm());
      for (int k = 1; k < svd.singularValues.size(); ++k) QVERIFY(svd.singularValues[k] <= svd.singularValues[k - 1]);
    }
  }

  /// Orthonormal columns, scaled: the scales are the singular values, each with its own digits.
  void smallSingularValuesKeepTheirDigits() {
    const MatrixXd columns = test::orthonormalised(randomMatrix(30, 30, 7)).leftCols(8);
    VectorXd scales(8);
    for (int k = 0; k < 8; ++k) scales[k] = std::pow(10.0, -2 * k);
    const ThinSvd svd = thinSvd(columns * scales.asDiagonal());
    for (int k = 0; k < 8; ++k) QVERIFY(std::abs(svd.singularValues[k] / scales[k] - 1) < 1e-13);
  }

  void singularVectorsOfDeficientMatrices() {
    for (const MatrixXd& m :
         {MatrixXd(randomMatrix(20, 3, 7) * randomMatrix(3, 9, 8)), MatrixXd(MatrixXd::Zero(6, 4))}) {
      const ThinSvd svd = thinSvd(m);
      QVERIFY(departureFromOrthonormal(svd.u) < 1e-13 && departureFromOrthonormal(svd.v) < 1e-13);
      QVERIFY((svd.u * svd.singularValues.asDiagonal() * svd.v.transpose() - m).norm() <= 1e-13 * m.norm());
    }
  }

  void symmetricSystemsOfSeveralRightSides() {
    const MatrixXd half = randomMatrix(12, 12, 7), a = half * half.transpose(), x = randomMatrix(12, 3, 7);
    QVERIFY((solveSymmetric(a, a * x) - x).norm() < 1e-9 * x.norm());
  }
};

GONIO_TEST(DecompositionsTest)
}  // namespace decompositions_test

#include "decompositions_test.moc"
