// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/canonical_polyadic.h"

#include <QTest>
#include <cmath>

#include "tests/core/factorization/factorization_test_support.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/test_program.h"

namespace canonical_polyadic_test {
using namespace gonio;
using namespace gonio::factorization;
using namespace gonio::factorization::test_support;

CanonicalPolyadic randomDecomposition(const std::vector<int>& sizes, int rank, unsigned seed) {
  CanonicalPolyadic result{.weights = Eigen::VectorXd::Ones(rank), .factors = {}};
  for (const int size : sizes) result.factors.push_back(randomMatrix(size, rank, seed++));
  return result;
}

bool allFinite(const CanonicalPolyadic& d) {
  bool finite = d.weights.allFinite() && std::isfinite(d.fit);
  for (const Eigen::MatrixXd& factor : d.factors) finite = finite && factor.allFinite();
  return finite;
}

class CanonicalPolyadicTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The entries of a composition, written out.
  void composition() {
    CanonicalPolyadic d = randomDecomposition({3, 4, 5}, 2, 1);
    d.weights << 2, -3;
    const Tensor tensor = compose(d);
    for (int k = 0; k < 5; ++k)
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 3; ++i) {
          double sum = 0;
          for (int r = 0; r < 2; ++r)
            sum += d.weights[r] * d.factors[0](i, r) * d.factors[1](j, r) * d.factors[2](k, r);
          QVERIFY(std::abs(tensor.at(i, j, k) - sum) < 1e-14);
        }
  }

  /// A tensor of low rank is found again, of any number of modes; its components up to their order.
  void findsTheComponents() {
    for (const std::vector<int>& sizes : {std::vector{7, 8}, {6, 7, 8}, {4, 5, 6, 7}}) {
      const int rank = sizes.size() == 2 ? 1 : 3;
      const Tensor tensor = compose(randomDecomposition(sizes, rank, 5));
      const CanonicalPolyadic found =
          decomposeCanonicalPolyadic(tensor, rank, {.maxIterations = 5000, .tolerance = 1e-15});
      QVERIFY2(found.fit > 1 - 1e-7, QByteArray::number(1 - found.fit));
      QVERIFY(std::abs(1 - found.fit - relativeDifference(compose(found), tensor)) < 1e-15);
    }
  }

  /// Of rank 1 the fit is that of the best rank-one tensor: for a matrix the leading singular value.
  void rankOneOfAMatrixIsTheLeadingSingularPair() {
    const Eigen::MatrixXd matrix = randomMatrix(9, 6, 4);
    const Eigen::VectorXd singular = test::singularValues(matrix);
    const CanonicalPolyadic found = decomposeCanonicalPolyadic(fold(matrix, 0, {9, 6}), 1, {.tolerance = 1e-14});
    QVERIFY(std::abs(found.weights[0] - singular[0]) < 1e-6);
    const double left = std::sqrt(singular.tail(5).squaredNorm()) / singular.norm();
    QVERIFY(std::abs(1 - found.fit - left) < 1e-9);
  }

  void moreComponentsFitBetter() {
    const Tensor tensor = randomTensor({6, 7, 5}, 3);
    double last = -1;
    for (int rank = 1; rank <= 8; ++rank) {
      const double fit = decomposeCanonicalPolyadic(tensor, rank).fit;
      QVERIFY(fit > last);
      last = fit;
    }
  }

  void signsAndLengthsAreSettled() {
    const CanonicalPolyadic d = decomposeCanonicalPolyadic(randomTensor({6, 7, 5}, 8), 3);
    for (std::size_t mode = 0; mode < 3; ++mode)
      for (int r = 0; r < 3; ++r) {
        QVERIFY(std::abs(d.factors[mode].col(r).norm() - 1) < 1e-12);
        if (mode < 2) QVERIFY(d.factors[mode].col(r).maxCoeff() >= -d.factors[mode].col(r).minCoeff());
      }
  }

  /// Doubled slices, and a rank beyond the tensor's: the pseudo-inverse keeps everything finite.
  void hardCase17RankDeficient() {
    CanonicalPolyadic low = randomDecomposition({6, 7, 8}, 1, 2);
    low.factors[1].row(3) = low.factors[1].row(2);
    const Tensor tensor = compose(low);
    for (const int rank : {1, 2, 4, 9}) {
      const CanonicalPolyadic d = decomposeCanonicalPolyadic(tensor, rank);
      QVERIFY(allFinite(d));
      QVERIFY2(d.fit > 1 - 1e-10, QByteArray::number(1 - d.fit));
    }
  }

  void hardCase18Zero() {
    const Tensor zero({3, 4, 5});
    const CanonicalPolyadic d = decomposeCanonicalPolyadic(zero, 2);
    QVERIFY(allFinite(d) && d.weights.isZero() && d.fit == 1);
    QCOMPARE(compose(d).norm(), 0.0);
  }

  /// The limit of rank-2 tensors whose own rank is 3: no best rank-2 approximation exists, the components diverge.
  void hardCase19DegenerateTensorsStayBounded() {
    const Eigen::MatrixXd a = randomMatrix(5, 2, 1), b = randomMatrix(6, 2, 2), c = randomMatrix(7, 2, 3);
    const auto term = [&](int i, int j, int k) {
      CanonicalPolyadic one{.weights = Eigen::VectorXd::Ones(1), .factors = {a.col(i), b.col(j), c.col(k)}};
      return compose(one);
    };
    Tensor tensor = term(1, 0, 0);
    const Tensor second = term(0, 1, 0), third = term(0, 0, 1);
    for (std::size_t i = 0; i < tensor.count(); ++i) tensor[i] += second[i] + third[i];
    const CanonicalPolyadic d = decomposeCanonicalPolyadic(tensor, 2);
    QVERIFY(allFinite(d) && d.iterations <= 500);
    QVERIFY(d.weights.cwiseAbs().maxCoeff() <= 1e6 * tensor.norm());
    QVERIFY(d.fit > 0.9);
  }

  void stopsWhenAsked() {
    std::stop_source source;
    source.request_stop();
    QVERIFY_EXCEPTION_THROWN(
        decomposeCanonicalPolyadic(randomTensor({4, 4, 4}, 1), 2, {}, {.stop = source.get_token()}), Cancelled);
  }
};

GONIO_TEST(CanonicalPolyadicTest)
}  // namespace canonical_polyadic_test

#include "canonical_polyadic_test.moc"
