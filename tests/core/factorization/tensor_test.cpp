// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/tensor.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/math/parallel.h"
#include "tests/support/random_matrix.h"
#include "tests/support/test_program.h"

namespace tensor_test {
using namespace gonio;
using namespace gonio::factorization;
using Matrix = Eigen::MatrixXd;
using gonio::test::randomMatrix;

Tensor randomTensor(std::vector<int> sizes, unsigned seed = 1) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  Tensor result(std::move(sizes));
  for (std::size_t i = 0; i < result.count(); ++i) result[i] = normal(generator);
  return result;
}

double difference(const Tensor& a, const Tensor& b) {
  double largest = a.sizes() == b.sizes() ? 0 : 1e300;
  for (std::size_t i = 0; i < a.count() && a.sizes() == b.sizes(); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// The operations of the dissertation's 3.1.1, written out.
class TensorTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void normAndInnerProduct() {
    const Tensor a = randomTensor({3, 4, 5}, 1), b = randomTensor({3, 4, 5}, 2);
    double inner = 0, squared = 0;
    for (int k = 0; k < 5; ++k)
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 3; ++i) {
          inner += a.at(i, j, k) * b.at(i, j, k);
          squared += a.at(i, j, k) * a.at(i, j, k);
        }
    QVERIFY(std::abs(innerProduct(a, b) - inner) < 1e-12);
    QVERIFY(std::abs(a.norm() - std::sqrt(squared)) < 1e-12);
  }

  /// Eq. 3.4: j = 1 + sum over p != k of (i_p - 1) times the product of the sizes of q < p, q != k.
  void unfoldingByItsFormula() {
    const std::vector<int> sizes{2, 3, 4, 5};
    const Tensor tensor = randomTensor(sizes);
    for (int mode = 0; mode < 4; ++mode) {
      const Matrix matrix = unfold(tensor, mode);
      QVERIFY(matrix.rows() == sizes[std::size_t(mode)] && matrix.cols() == 120 / sizes[std::size_t(mode)]);
      for (std::size_t at = 0; at < tensor.count(); ++at) {
        std::size_t rest = at, column = 0, stride = 1, row = 0;
        for (int p = 0; p < 4; ++p) {
          const std::size_t size = std::size_t(sizes[std::size_t(p)]), index = rest % size;
          rest /= size;
          if (p == mode) {
            row = index;
          } else {
            column += index * stride;
            stride *= size;
          }
        }
        QCOMPARE(matrix(Eigen::Index(row), Eigen::Index(column)), tensor[at]);
      }
      QCOMPARE(difference(fold(matrix, mode, sizes), tensor), 0.0);
    }
  }

  void modeProductIsTheProductWithTheUnfolding() {
    const Tensor tensor = randomTensor({4, 3, 5, 2});
    for (int mode = 0; mode < 4; ++mode) {
      const Matrix u = randomMatrix(6, tensor.size(mode), 3);
      std::vector<int> sizes = tensor.sizes();
      sizes[std::size_t(mode)] = 6;
      const Tensor expected = fold(u * unfold(tensor, mode), mode, sizes);
      QVERIFY(difference(modeProduct(tensor, u, mode), expected) < 1e-13);
      QVERIFY(difference(transposedModeProduct(tensor, u.transpose(), mode), expected) < 1e-13);
    }
  }

  /// Products along different modes commute, those along one multiply.
  void modeProductRules() {
    const Tensor tensor = randomTensor({4, 3, 5});
    const Matrix a = randomMatrix(6, 4, 1), b = randomMatrix(2, 5, 2), c = randomMatrix(3, 6, 3);
    QVERIFY(difference(modeProduct(modeProduct(tensor, a, 0), b, 2), modeProduct(modeProduct(tensor, b, 2), a, 0)) <
            1e-13);
    QVERIFY(difference(modeProduct(modeProduct(tensor, a, 0), c, 0), modeProduct(tensor, c * a, 0)) < 1e-13);
  }

  void blocksOfLargeTensorsJoin() {
    const Tensor tensor = randomTensor({700, 3, 2});
    const Matrix first = randomMatrix(5, 700, 1), second = randomMatrix(4, 3, 2), third = randomMatrix(4, 2, 3);
    const std::vector<Matrix> matrices{first, second, third};
    for (int mode = 0; mode < 3; ++mode) {
      std::vector<int> sizes = tensor.sizes();
      sizes[std::size_t(mode)] = int(matrices[std::size_t(mode)].rows());
      QVERIFY(difference(modeProduct(tensor, matrices[std::size_t(mode)], mode),
                         fold(matrices[std::size_t(mode)] * unfold(tensor, mode), mode, sizes)) < 1e-11);
    }
  }

  void hardCase50SameBitsForAnyNumberOfThreads() {
    const Tensor tensor = randomTensor({90, 40, 60});
    const Matrix u = randomMatrix(30, 60, 4);
    const Tensor all = modeProduct(tensor, u, 2);
    const double norm = tensor.norm();
    const ThreadLimit one(1);
    QCOMPARE(difference(modeProduct(tensor, u, 2), all), 0.0);
    QCOMPARE(tensor.norm(), norm);
  }

  void kroneckerAndKhatriRao() {
    const Matrix a = randomMatrix(2, 3, 1), b = randomMatrix(4, 3, 2);
    const Matrix kronecker = kroneckerProduct(a, b), khatriRao = khatriRaoProduct(a, b);
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 4; ++k) {
          for (int l = 0; l < 3; ++l) QCOMPARE(kronecker(i * 4 + k, j * 3 + l), a(i, j) * b(k, l));
          QCOMPARE(khatriRao(i * 4 + k, j), a(i, j) * b(k, j));
        }
  }

  /// A rank-one sum unfolds to A_n times the transposed Khatri-Rao product of the others, the last mode outermost.
  void khatriRaoMatchesTheUnfolding() {
    const std::vector<Matrix> factors{randomMatrix(3, 2, 1), randomMatrix(4, 2, 2), randomMatrix(5, 2, 3)};
    Tensor tensor({3, 4, 5});
    for (int r = 0; r < 2; ++r)
      for (int k = 0; k < 5; ++k)
        for (int j = 0; j < 4; ++j)
          for (int i = 0; i < 3; ++i) tensor.at(i, j, k) += factors[0](i, r) * factors[1](j, r) * factors[2](k, r);
    const auto close = [](const Matrix& x, const Matrix& y) { return (x - y).cwiseAbs().maxCoeff() < 1e-13; };
    QVERIFY(close(unfold(tensor, 0), factors[0] * khatriRaoProduct(factors[2], factors[1]).transpose()));
    QVERIFY(close(unfold(tensor, 1), factors[1] * khatriRaoProduct(factors[2], factors[0]).transpose()));
    QVERIFY(close(unfold(tensor, 2), factors[2] * khatriRaoProduct(factors[1], factors[0]).transpose()));
  }
};

GONIO_TEST(TensorTest)
}  // namespace tensor_test

#include "tensor_test.moc"
