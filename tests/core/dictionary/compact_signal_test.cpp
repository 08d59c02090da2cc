// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/largest_projections.h"

#include <QTest>
#include <algorithm>

#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/test_program.h"

namespace compact_signal_test {
using namespace gonio;
using namespace gonio::factorization;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

constexpr Sizes sizes{9, 7, 8};

/// A signal whose modes have a decaying spectrum.
Eigen::VectorXd smoothSignal(std::mt19937_64& random) {
  Tensor coefficients({sizes[0], sizes[1], sizes[2]});
  for (std::size_t i = 0; i < coefficients.count(); ++i) {
    const std::size_t order = i % 9 + i / 9 % 7 + i / 63;
    coefficients[i] = std::exp(-double(order * order) / 8) * (i % 2 == 0 ? 1 : -1);
  }
  const Tensor signal = composed(coefficients, randomDictionary(sizes, random));
  return Eigen::Map<const Eigen::VectorXd>(signal.data(), Eigen::Index(signal.count()));
}

class CompactSignalTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The block, expanded by the bases, differs from the signal by no more energy than allowed, and saves something.
  void omitsNoMoreThanAllowed() {
    std::mt19937_64 random(1);
    const Eigen::VectorXd signal = smoothSignal(random);
    std::size_t former = count(sizes) + 1;
    for (const double maxLoss : {0.0, 1e-8, 1e-4, 1e-2}) {
      const auto compact = compactSignal<double>(signal.data(), sizes, maxLoss);
      Tensor expanded = tensorOf(compact.block.data(), compact.ranks);
      for (int mode = 0; mode < 3; ++mode) {
        QVERIFY(orthonormalityError(compact.bases[std::size_t(mode)]) < 1e-12);
        expanded = modeProduct(expanded, compact.bases[std::size_t(mode)], mode);
      }
      const double omitted = (Eigen::Map<const Eigen::VectorXd>(expanded.data(), signal.size()) - signal).squaredNorm();
      QCOMPARE(compact.energy, signal.squaredNorm());
      QVERIFY2(omitted <= (maxLoss + 1e-14) * compact.energy, qPrintable(QString::number(omitted)));
      QVERIFY(compact.block.size() < former);
      former = compact.block.size();
    }
  }

  /// Without loss, the coefficients are those of the signal itself.
  void coefficientsOfTheSignal() {
    std::mt19937_64 random(2);
    const Eigen::VectorXd signal = Eigen::VectorXd::Random(Eigen::Index(count(sizes)));
    const ModeMatrices<double> dictionary = randomDictionary(sizes, random);
    Workspace<double> workspace;
    std::vector<Coefficient<double>> expected, found;
    selectLargestProjections(signal.data(), sizes, dictionary, 25, workspace, expected);
    compactSignal<double>(signal.data(), sizes, 0).selectLargest(dictionary, 25, workspace, found);
    std::ranges::sort(expected, isLarger<double>);
    std::ranges::sort(found, isLarger<double>);
    QCOMPARE(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      QCOMPARE(found[i].index, expected[i].index);
      QVERIFY(std::abs(found[i].value - expected[i].value) < 1e-12);
    }
  }

  /// A signal of zeros has a block of one zero.
  void signalOfZeros() {
    const Eigen::VectorXd zeros = Eigen::VectorXd::Zero(Eigen::Index(count(sizes)));
    const auto compact = compactSignal<double>(zeros.data(), sizes, 1e-5);
    QCOMPARE(compact.block, BlockStorage<double>{0});
    QCOMPARE(compact.energy, 0.0);
  }

  /// The correlation by its definition, with matrices that are not square and coefficients in few and in many atoms.
  void correlationByBruteForce() {
    std::mt19937_64 random(3);
    const Eigen::VectorXd signal = Eigen::VectorXd::Random(Eigen::Index(count(sizes)));
    ModeMatrices<double> u;
    for (std::size_t mode = 0; mode < 3; ++mode) u[mode] = Eigen::MatrixXd::Random(sizes[mode], 6 - Eigen::Index(mode));
    const std::array<std::size_t, 3> strides{1, 9, 63};
    for (const std::uint32_t coefficients : {0u, 1u, 5u, 120u})
      for (std::size_t m = 0; m < 3; ++m) {
        const std::size_t p = (m + 1) % 3, q = (m + 2) % 3;
        std::vector<Coefficient<double>> sparse;
        Eigen::MatrixXd expected = Eigen::MatrixXd::Ones(sizes[m], u[m].cols());
        for (std::uint32_t n = 0; n < coefficients; ++n) {
          const auto index = coefficients == 120 ? n : std::uint32_t(random() % 120);
          sparse.push_back({index, double(n) - 2.5});
          const std::array<Eigen::Index, 3> atom{index % 6, index / 6 % 5, index / 30};
          for (int i = 0; i < sizes[m]; ++i)
            for (int j = 0; j < sizes[p]; ++j)
              for (int k = 0; k < sizes[q]; ++k)
                expected(i, atom[m]) += sparse.back().value * u[p](j, atom[p]) * u[q](k, atom[q]) *
                                        signal[Eigen::Index(std::size_t(i) * strides[m] + std::size_t(j) * strides[p] +
                                                            std::size_t(k) * strides[q])];
        }
        Eigen::MatrixXd z = Eigen::MatrixXd::Ones(sizes[m], u[m].cols());
        Workspace<double> workspace;
        addCorrelation(signal.data(), sizes, u, int(m), sparse, workspace, z);
        QVERIFY2((z - expected).norm() <= 1e-12 * expected.norm(), qPrintable(QString::number(coefficients)));
      }
  }
};

GONIO_TEST(CompactSignalTest)
}  // namespace compact_signal_test

#include "compact_signal_test.moc"
