// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/decompositions.h"

#include <QTest>
#include <random>

#include "core/math/parallel.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/test_program.h"

namespace gram_svd_test {
using namespace gonio;

TallMatrix randomTall(int rows, int columns, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<float> normal;
  TallMatrix result{std::vector<float>(std::size_t(rows) * std::size_t(columns)), rows, columns};
  for (float& value : result.values) value = normal(generator);
  return result;
}

double orthonormalityError(const TallMatrix& u) {
  const Eigen::MatrixXd wide = u.view().cast<double>();
  return (wide.transpose() * wide - Eigen::MatrixXd::Identity(wide.cols(), wide.cols())).cwiseAbs().maxCoeff();
}

constexpr int all = 1000;

class GramSvdTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Rows that fill no block, one block, and many.
  void gramMatrixByItsDefinition() {
    for (const int rows : {1, 7, 512, 513, 40000}) {
      const TallMatrix matrix = randomTall(rows, 5, unsigned(rows));
      const Eigen::MatrixXd wide = matrix.view().cast<double>(), expected = wide.transpose() * wide;
      QVERIFY((gramMatrix(matrix) - expected).norm() <= 1e-14 * expected.norm());
    }
  }

  void agreesWithJacobi() {
    TallMatrix matrix = randomTall(3000, 12, 1);
    matrix.view().col(3) *= 100;
    matrix.view().col(7) *= 1e-3f;
    const Eigen::MatrixXd wide = matrix.view().cast<double>();
    const test::JacobiSvd expected = test::jacobiSvd(wide);
    const GramSvd svd = decomposeGramSvd(matrix, all);
    QCOMPARE(svd.singularValues.size(), Eigen::Index(12));
    QVERIFY((svd.singularValues - expected.values).norm() < 1e-10 * expected.values[0]);
    QVERIFY(orthonormalityError(svd.u) < 1e-6);
    QVERIFY((svd.v.transpose() * svd.v - Eigen::MatrixXd::Identity(12, 12)).norm() < 1e-13);
    const Eigen::MatrixXd product = svd.u.view().cast<double>() * svd.singularValues.asDiagonal() * svd.v.transpose();
    QVERIFY((product - wide).norm() < 1e-6 * wide.norm());
    for (Eigen::Index c = 0; c < 12; ++c) QVERIFY(svd.v.col(c).maxCoeff() >= -0.5 * svd.v.col(c).minCoeff());
  }

  void strongestComponentsOnly() {
    const TallMatrix matrix = randomTall(500, 9, 2);
    const GramSvd whole = decomposeGramSvd(matrix, all), part = decomposeGramSvd(matrix, 4);
    QCOMPARE(part.u.columns, Eigen::Index(4));
    QCOMPARE(part.u.values.size(), std::size_t(4 * 500));
    QVERIFY(part.singularValues == whole.singularValues.head(4));
    QVERIFY((part.u.view() - whole.u.view().leftCols(4)).norm() < 1e-6);
  }

  /// Two blocks of rows, more columns than a tile has.
  void gramMatrixByBlocks() {
    const TallMatrix matrix = randomTall(300, 150, 3);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(150, 150);
    for (const auto& [first, count] : {std::pair{0, 170}, {170, 130}}) {
      TallMatrix block{.values = std::vector<float>(std::size_t(count) * 150), .rows = count, .columns = 150};
      block.view() = matrix.view().middleRows(first, count);
      addToGram(sum, block);
    }
    const Eigen::MatrixXd expected = gramMatrix(matrix), lower = sum.triangularView<Eigen::Lower>();
    QVERIFY((lower - Eigen::MatrixXd(expected.triangularView<Eigen::Lower>())).norm() <= 1e-13 * expected.norm());
  }

  /// Repeated, zero and summed columns: as many components as the rank, and those orthonormal.
  void hardCase24WeakComponentsAreDropped() {
    TallMatrix matrix = randomTall(2000, 8, 3);
    auto view = matrix.view();
    view.col(4) = view.col(0);
    view.col(5).setZero();
    view.col(6) = -2 * view.col(1);
    const GramSvd svd = decomposeGramSvd(matrix, all);
    QCOMPARE(svd.singularValues.size(), Eigen::Index(5));
    QVERIFY(orthonormalityError(svd.u) < 1e-6);
    const Eigen::MatrixXd product = svd.u.view().cast<double>() * svd.singularValues.asDiagonal() * svd.v.transpose();
    QVERIFY((product - view.cast<double>()).norm() < 1e-6 * view.cast<double>().norm());
    // The left inverse Sigma^-1 U^T of U Sigma, which samples are reconstructed with.
    const Eigen::MatrixXd left =
        svd.singularValues.cwiseInverse().asDiagonal() * svd.u.view().cast<double>().transpose();
    const Eigen::MatrixXd identity = left * svd.u.view().cast<double>() * svd.singularValues.asDiagonal();
    QVERIFY((identity - Eigen::MatrixXd::Identity(5, 5)).cwiseAbs().maxCoeff() < 1e-6);
  }

  void hardCase14ZeroHasNoComponents() {
    const TallMatrix zero{std::vector<float>(300, 0.0f), 100, 3};
    const GramSvd svd = decomposeGramSvd(zero, all);
    QCOMPARE(svd.singularValues.size(), Eigen::Index(0));
    QCOMPARE(svd.u.rows, Eigen::Index(100));
    QVERIFY(svd.u.values.empty());
  }

  void hardCase50SameBitsForAnyThreads() {
    const TallMatrix matrix = randomTall(30000, 6, 4);
    const GramSvd many = decomposeGramSvd(matrix, all);
    const ThreadLimit limit(1);
    const GramSvd one = decomposeGramSvd(matrix, all);
    QVERIFY(one.u.values == many.u.values && one.singularValues == many.singularValues && one.v == many.v);
  }

  void progressAndStop() {
    double last = 0;
    bool falls = false;
    decomposeGramSvd(randomTall(5000, 3, 5), all, {{}, [&](double fraction) {
                                                     falls = falls || fraction < last;
                                                     last = fraction;
                                                   }});
    QVERIFY(!falls);
    QVERIFY(std::abs(last - 1) < 1e-12);
    std::stop_source source;
    source.request_stop();
    QVERIFY_EXCEPTION_THROWN(decomposeGramSvd(randomTall(5000, 3, 5), all, {source.get_token(), {}}), Cancelled);
  }
};

GONIO_TEST(GramSvdTest)
}  // namespace gram_svd_test

#include "gram_svd_test.moc"
