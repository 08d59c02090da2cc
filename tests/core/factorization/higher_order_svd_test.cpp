// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/canonical_polyadic.h"

#include <QTest>
#include <cmath>

#include "tests/core/factorization/factorization_test_support.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/test_program.h"

namespace higher_order_svd_test {
using namespace gonio;
using namespace gonio::factorization;
using namespace gonio::factorization::test_support;

class HigherOrderSvdTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void exactInFull() {
    for (const std::vector<int>& sizes : {std::vector{7, 8}, {6, 7, 8}, {3, 4, 5, 6}}) {
      const Tensor tensor = randomTensor(sizes, 1);
      const HigherOrderSvd d = decomposeHigherOrderSvd(tensor);
      QVERIFY(relativeDifference(compose(d), tensor) < 1e-13);
      for (const Eigen::MatrixXd& factor : d.factors)
        QVERIFY((factor.transpose() * factor - Eigen::MatrixXd::Identity(factor.cols(), factor.cols())).norm() < 1e-12);
    }
  }

  /// The slices of the core are orthogonal, and their norms are the singular values of the unfolding.
  void coreIsAllOrthogonal() {
    const Tensor tensor = randomTensor({5, 6, 7}, 2);
    const HigherOrderSvd d = decomposeHigherOrderSvd(tensor);
    for (int mode = 0; mode < 3; ++mode) {
      const Eigen::MatrixXd core = unfold(d.core, mode), gram = core * core.transpose();
      const Eigen::VectorXd singular = test::singularValues(unfold(tensor, mode));
      for (int i = 0; i < gram.rows(); ++i)
        for (int j = 0; j < gram.cols(); ++j)
          QVERIFY(std::abs(gram(i, j) - (i == j ? singular[i] * singular[i] : 0)) < 1e-10);
    }
  }

  void truncationErrorIsBounded() {
    const Tensor tensor = randomTensor({6, 7, 8}, 3);
    const std::vector<int> ranks{3, 4, 2};
    const HigherOrderSvd d = decomposeHigherOrderSvd(tensor, ranks);
    QVERIFY(d.core.sizes() == ranks);
    double bound = 0, least = 0;
    for (int mode = 0; mode < 3; ++mode) {
      const Eigen::VectorXd singular = test::singularValues(unfold(tensor, mode));
      const double left = singular.tail(singular.size() - ranks[std::size_t(mode)]).squaredNorm();
      bound += left;
      least = std::max(least, left);
    }
    const double error = relativeDifference(compose(d), tensor) * tensor.norm();
    QVERIFY(error * error <= bound && error * error >= least);
  }

  void lowMultilinearRankIsFound() {
    Tensor tensor = randomTensor({2, 3, 2}, 4);
    for (int mode = 0; mode < 3; ++mode) tensor = modeProduct(tensor, randomMatrix(8, tensor.size(mode), 9), mode);
    QVERIFY(relativeDifference(compose(decomposeHigherOrderSvd(tensor, {2, 3, 2})), tensor) < 1e-12);
  }

  void hardCase18Zero() {
    const HigherOrderSvd d = decomposeHigherOrderSvd(Tensor({3, 4, 5}), {2, 2, 2});
    QCOMPARE(compose(d).norm(), 0.0);
    for (const Eigen::MatrixXd& factor : d.factors)
      QVERIFY((factor.transpose() * factor - Eigen::MatrixXd::Identity(2, 2)).norm() < 1e-12);
  }
};

GONIO_TEST(HigherOrderSvdTest)
}  // namespace higher_order_svd_test

#include "higher_order_svd_test.moc"
