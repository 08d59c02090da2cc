// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <algorithm>

#include "core/dictionary/decode.h"
#include "core/dictionary/invalid_cells.h"
#include "core/dictionary/largest_projections.h"
#include "core/dictionary/mode_products.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/test_program.h"

namespace sparse_blocks_test {
using namespace gonio;
using namespace gonio::factorization;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

template <typename Scalar>
std::vector<Coefficient<Scalar>> sortedByIndex(std::vector<Coefficient<Scalar>> coefficients) {
  std::sort(coefficients.begin(), coefficients.end(), [](auto& a, auto& b) { return a.index < b.index; });
  return coefficients;
}

std::vector<Coefficient<double>> keptByFullSort(const std::vector<double>& values, std::size_t count) {
  std::vector<Coefficient<double>> all;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] != 0) all.push_back({std::uint32_t(i), values[i]});
  std::sort(all.begin(), all.end(), isLarger<double>);
  all.resize(std::min(all.size(), count));
  return sortedByIndex(all);
}

class SparseBlocksTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void productsAreThoseOfTensors() {
    std::mt19937_64 random(1);
    const Sizes sizes{5, 4, 6};
    const Matrix<double> block = Matrix<double>::Random(Eigen::Index(count(sizes)), 1);
    ModeMatrices<double> matrices;
    for (std::size_t mode = 0; mode < 3; ++mode) matrices[mode] = Matrix<double>::Random(sizes[mode], int(mode) + 2);
    for (int skipped = -1; skipped < 3; ++skipped) {
      Tensor expected = tensorOf(block.data(), sizes);
      for (int mode = 0; mode < 3; ++mode)
        if (mode != skipped) expected = transposedModeProduct(expected, matrices[std::size_t(mode)], mode);
      Workspace<double> workspace;
      const double* result = transposedModeProducts(block.data(), sizes, matrices, workspace, skipped, {2, 0, 1});
      for (std::size_t i = 0; i < expected.count(); ++i) QVERIFY(std::abs(result[i] - expected[i]) < 1e-14);
    }
  }

  void keepsTheLargest() {
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    std::vector<double> values(5000);
    for (double& v : values) v = normal(random);
    std::vector<Coefficient<double>> kept;
    for (const std::size_t count : {1, 7, 64, 300, 4999}) {
      selectLargest(std::span<const double>(values), count, kept);
      const auto expected = keptByFullSort(values, count);
      kept = sortedByIndex(kept);
      QCOMPARE(kept.size(), expected.size());
      for (std::size_t i = 0; i < kept.size(); ++i) QCOMPARE(kept[i].index, expected[i].index);
    }
  }

  /// A count of all entries keeps all; a count of 0 none.
  void hardCase26AllOrNoCoefficients() {
    const std::vector<double> values{3, -1, 0.5, 2};
    std::vector<Coefficient<double>> kept;
    selectLargest(std::span<const double>(values), 4, kept);
    QCOMPARE(kept.size(), std::size_t(4));
    selectLargest(std::span<const double>(values), 100, kept);
    QCOMPARE(kept.size(), std::size_t(4));
    QCOMPARE(energy<double>(kept), 9 + 1 + 0.25 + 4);
    selectLargest(std::span<const double>(values), 0, kept);
    QVERIFY(kept.empty());
  }

  /// Among equals the lower indices stay.
  void hardCase27Ties() {
    std::vector<double> values(1000);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = i % 3 == 0 ? -1 : 1;
    values[500] = 2;
    std::vector<Coefficient<double>> kept;
    selectLargest(std::span<const double>(values), 10, kept);
    const auto expected = keptByFullSort(values, 10);
    kept = sortedByIndex(kept);
    QCOMPARE(kept.size(), expected.size());
    for (std::size_t i = 0; i < kept.size(); ++i) QCOMPARE(kept[i].index, expected[i].index);
    QCOMPARE(kept.back().index, 500u);
  }

  /// The largest coefficients of a projection without the others: those that the whole projection has, of a signal that
  /// the dictionary holds in few coefficients as of noise, which it does not.
  void largestOfAProjection() {
    std::mt19937_64 random(4);
    const Sizes sizes{18, 9, 10};
    ModeMatrices<float> matrices;
    const ModeMatrices<double> wide = randomDictionary(sizes, random);
    for (std::size_t mode = 0; mode < 3; ++mode) matrices[mode] = wide[mode].leftCols(6 + int(mode)).cast<float>();
    const std::size_t all = 6 * 7 * 8;
    for (const float decay : {0.f, 0.02f, 0.3f}) {
      std::vector<Coefficient<float>> truth;
      for (std::size_t i = 0; i < all; ++i) {
        // Of the whole dictionary, whose first atoms are those of `matrices`.
        const std::size_t place = (i * 37) % all, atom0 = place % 6, atom1 = place / 6 % 7, atom2 = place / 42;
        truth.push_back(
            {std::uint32_t(atom0 + 18 * (atom1 + 9 * atom2)), (i % 2 == 0 ? 1.f : -1.f) * std::exp(-decay * float(i))});
      }
      Eigen::VectorXf signal(Eigen::Index(count(sizes)));
      compose<float>({wide[0].cast<float>(), wide[1].cast<float>(), wide[2].cast<float>()}, truth, signal.data());
      if (decay == 0) signal.setRandom();
      Workspace<float> workspace;
      const float* projection = transposedModeProducts(signal.data(), sizes, matrices, workspace);
      const std::vector<float> values(projection, projection + all);
      for (const std::size_t kept : {std::size_t(0), std::size_t(1), std::size_t(20), all}) {
        if (kept == all && decay > 0) continue;  // the least of them are rounding alone
        std::vector<Coefficient<float>> expected, found;
        selectLargest(std::span<const float>(values), kept, expected);
        selectLargestProjections(signal.data(), sizes, matrices, kept, workspace, found);
        expected = sortedByIndex(expected);
        found = sortedByIndex(found);
        QCOMPARE(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
          QCOMPARE(found[i].index, expected[i].index);
          QVERIFY(std::abs(found[i].value - expected[i].value) < 1e-6f);
        }
      }
    }
  }

  /// Rounds that compute only what changes, against whole blocks: invalid cells in a corner, scattered, none and all.
  void invalidCellsTakeTheCodesValues() {
    std::mt19937_64 random(6);
    const Sizes sizes{18, 9, 10};
    ModeMatrices<float> matrices;
    const ModeMatrices<double> wide = randomDictionary(sizes, random);
    for (std::size_t mode = 0; mode < 3; ++mode) matrices[mode] = wide[mode].cast<float>();
    for (const int pattern : {0, 1, 2, 3}) {
      std::vector<std::uint8_t> valid(count(sizes));
      for (std::size_t cell = 0; cell < valid.size(); ++cell) {
        const std::size_t row = cell / 18 % 9, slice = cell / 162;
        valid[cell] = pattern == 0 ? row + slice < 12 : pattern == 1 ? cell % 97 != 5 : pattern == 2;
      }
      Eigen::ArrayXf signal = Eigen::ArrayXf::Random(Eigen::Index(valid.size())), expected = signal;
      Eigen::ArrayXf before, now(expected.size());
      InvalidCellRefinement<float> rounds(signal, valid, sizes, matrices);
      std::vector<Coefficient<float>> found, kept;
      Workspace<float> workspace;
      for (int round = 0; round < 4; ++round) {
        rounds.selectLargest(60, found);
        selectLargestProjections(expected.data(), sizes, matrices, 60, workspace, kept);
        found = sortedByIndex(found);
        kept = sortedByIndex(kept);
        QCOMPARE(found.size(), kept.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
          QCOMPARE(found[i].index, kept[i].index);
          QVERIFY(std::abs(found[i].value - kept[i].value) < 1e-5f);
        }
        rounds.update(found, 0.3f);
        compose(matrices, kept, now.data());
        if (round == 0) before = now;
        for (Eigen::Index cell = 0; cell < now.size(); ++cell)
          if (valid[std::size_t(cell)] == 0) expected[cell] = now[cell] + 0.3f * (now[cell] - before[cell]);
        before = now;
        QVERIFY((signal - expected).abs().maxCoeff() < 1e-5f);
      }
    }
  }

  /// Few coefficients compose to what the full tensor products give.
  void composesAsTensors() {
    std::mt19937_64 random(3);
    const Sizes sizes{7, 5, 6};
    const ModeMatrices<double> matrices = randomDictionary(sizes, random);
    for (const std::size_t coefficients : {0, 1, 9, 210}) {
      Tensor sparse({7, 5, 6});
      std::vector<Coefficient<double>> list;
      for (std::size_t t = 0; t < coefficients; ++t) {
        const auto index = std::uint32_t(coefficients == 210 ? t : random() % sparse.count());
        if (sparse[index] != 0) continue;
        list.push_back({index, double(t + 1)});
        sparse[index] = double(t + 1);
      }
      std::shuffle(list.begin(), list.end(), random);
      std::vector<double> block(sparse.count(), -1);
      compose(matrices, list, block.data());
      const Tensor expected = composed(sparse, matrices);
      for (std::size_t i = 0; i < block.size(); ++i) QVERIFY(std::abs(block[i] - expected[i]) < 1e-11);
    }
  }

  /// The orthogonal matrix of the largest trace, by trying rotations.
  void procrustesMaximisesTheTrace() {
    std::mt19937_64 random(4);
    const Eigen::MatrixXd z = Eigen::MatrixXd::Random(6, 6);
    const double best = (orthogonalProcrustes(z).transpose() * z).trace();
    for (int trial = 0; trial < 200; ++trial)
      QVERIFY((randomOrthonormal(6, random).transpose() * z).trace() <= best + 1e-12);
    // Of an orthogonal matrix times a positive one, the orthogonal one.
    const Eigen::MatrixXd rotation = randomOrthonormal(6, random);
    const Eigen::MatrixXd positive = z * z.transpose() + Eigen::MatrixXd::Identity(6, 6);
    QVERIFY((orthogonalProcrustes(rotation * positive) - rotation).norm() < 1e-12);
  }

  void hardCase29ProcrustesOfLowRank() {
    QVERIFY(orthonormalityError(orthogonalProcrustes(Eigen::MatrixXd::Zero(20, 20))) < 1e-12);
    const Eigen::VectorXd u = Eigen::VectorXd::Random(20), v = Eigen::VectorXd::Random(20);
    const Eigen::MatrixXd z = u * v.transpose();
    const Eigen::MatrixXd rotation = orthogonalProcrustes(z);
    QVERIFY(orthonormalityError(rotation) < 1e-12);
    // The trace's bound is the nuclear norm.
    QVERIFY(std::abs((rotation.transpose() * z).trace() - u.norm() * v.norm()) < 1e-11);
  }

  void polishingSquaresTheError() {
    std::mt19937_64 random(5);
    const Eigen::MatrixXd exact = randomOrthonormal(50, random);
    const Eigen::MatrixXd rounded = exact.cast<float>().cast<double>();
    QVERIFY(orthonormalityError(rounded) > 1e-9);
    QVERIFY(orthonormalityError(polished(rounded)) < 1e-13);
    QVERIFY((polished(rounded) - rounded).cwiseAbs().maxCoeff() < 1e-6);
  }
};

GONIO_TEST(SparseBlocksTest)
}  // namespace sparse_blocks_test

#include "sparse_blocks_test.moc"
