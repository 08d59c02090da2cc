// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/sample_selection.h"

#include <QTest>

#include "core/math/parallel.h"
#include "core/support/error.h"
#include "tests/core/acquisition/selection_test_support.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/test_program.h"

namespace sample_selection_test {
using namespace gonio;
using namespace gonio::acquisition;
using namespace gonio::acquisition::test_support;

constexpr SelectionMethod pursuits[] = {SelectionMethod::simultaneousPursuit,
                                        SelectionMethod::simultaneousPursuitFirstColumns,
                                        SelectionMethod::simultaneousPursuitUnnormalised};

PlainPursuit plain(const dictionary::PrincipalComponents& basis, const SelectionOptions& options) {
  const int components = options.components > 0 ? options.components : options.samples;
  const bool few = options.method == SelectionMethod::simultaneousPursuitFirstColumns;
  return plainPursuit(basis, components, few ? components : basis.svd.v.rows(), options.samples,
                      measurableCells(basis, options.measurable),
                      options.method != SelectionMethod::simultaneousPursuitUnnormalised);
}

/// The same cells, and the same residuals to rounding, which never rise.
void compareWithPlain(const dictionary::PrincipalComponents& basis, const SelectionOptions& options) {
  const SampleSelection fast = selectSamples(basis, options);
  const PlainPursuit expected = plain(basis, options);
  QVERIFY2(fast.cells == expected.cells, qPrintable(QString::number(options.samples)));
  QCOMPARE(fast.residuals.size(), expected.residuals.size());
  for (std::size_t k = 0; k < fast.residuals.size(); ++k) {
    QVERIFY(std::abs(fast.residuals[k] - expected.residuals[k]) < 1e-10);
    QVERIFY(k == 0 || fast.residuals[k] <= fast.residuals[k - 1]);
  }
  QVERIFY(isDistinctAmong(fast.cells, measurableCells(basis, options.measurable)));
  QVERIFY(std::isfinite(fast.conditionNumber) && fast.conditionNumber >= 1);
}

class SampleSelectionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void equalsPlainOnSmallProblems() {
    for (unsigned seed = 1; seed <= 40; ++seed) {
      const auto basis = randomBasis(40 + 5 * seed, 30, 12, seed);
      for (const SelectionMethod method : pursuits)
        for (const int samples : {1, 2, 7, 12})
          compareWithPlain(basis, {.method = method, .samples = samples, .measurable = everything});
    }
  }

  /// Several blocks of atoms, several changes of the coordinates, more components than samples.
  void equalsPlainOnMediumProblems() {
    const HalfDifferenceGrid grid{.thetaHCount = 24, .thetaDCount = 18, .phiDCount = 16};
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const auto basis = basisOf(orthonormalColumns(4500, 40, seed), orthonormalColumns(90, 40, seed + 50), grid);
      QVERIFY(basis.mapping.cells.size() > 3000);
      for (const SelectionMethod method : pursuits) {
        compareWithPlain(basis, {.method = method, .samples = 40});
        compareWithPlain(basis, {.method = method, .samples = 25, .components = 33});
      }
    }
  }

  /// Signals that are not orthonormal: of any scale, some of them 0 or the same.
  void anySignals() {
    for (unsigned seed = 1; seed <= 10; ++seed) {
      Eigen::MatrixXd v = randomMatrix(25, 10, seed) * std::pow(10.0, double(seed) - 5);
      v.row(3).setZero();
      v.row(5) = v.row(4);
      const auto basis = basisOf(orthonormalColumns(300, 10, seed), v);
      for (const SelectionMethod method : pursuits)
        compareWithPlain(basis, {.method = method, .samples = 9, .components = 10});
    }
  }

  /// Neighbours that are nearly the same, as those of a fine grid are: bounds in single precision cannot distinguish
  /// them.
  void nearlyEqualAtoms() {
    for (unsigned seed = 1; seed <= 10; ++seed) {
      Eigen::MatrixXd u = orthonormalColumns(400, 10, seed);
      for (Eigen::Index i = 0; i < u.rows(); ++i)
        u.row(i) = u.row(i / 20 * 20) * (1 + 1e-7 * double(i % 20)) + 1e-6 * u.row(i);
      const auto basis = basisOf(u, orthonormalColumns(30, 10, 90 + seed));
      for (const SelectionMethod method : pursuits) compareWithPlain(basis, {.method = method, .samples = 10});
    }
  }

  void hardCase50SameCellsForAnyThreads() {
    const HalfDifferenceGrid grid{.thetaHCount = 24, .thetaDCount = 18, .phiDCount = 16};
    const auto basis = basisOf(orthonormalColumns(5000, 30, 7), orthonormalColumns(60, 30, 8), grid);
    for (const SelectionMethod method : pursuits) {
      const SelectionOptions options{.method = method, .samples = 30};
      const SampleSelection all = selectSamples(basis, options);
      for (const int threads : {1, 2, 3}) {
        const ThreadLimit limit(threads);
        const SampleSelection some = selectSamples(basis, options);
        QVERIFY(some.cells == all.cells && some.residuals == all.residuals);
        QVERIFY(some.conditionNumber == all.conditionNumber);
      }
    }
  }

  /// All subsets are tried: with one signal the first choice is the best single cell, and where atoms are orthonormal
  /// every choice is the best subset of its size.
  void bestSubsetByBruteForce() {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const auto basis = basisOf(orthonormalColumns(8, 8, seed).eval(), randomMatrix(1, 8, seed + 30));
      auto even = basis;
      even.svd.singularValues.setOnes();
      const auto residualOf = [](const dictionary::PrincipalComponents& b, unsigned subset) {
        const Eigen::MatrixXd atoms = unitAtoms(b, 8);
        Eigen::MatrixXd support(8, 0);
        for (Eigen::Index i = 0; i < 8; ++i)
          if (subset >> i & 1U) {
            support.conservativeResize(Eigen::NoChange, support.cols() + 1);
            support.rightCols<1>() = atoms.col(i);
          }
        const Eigen::MatrixXd s = b.svd.v.transpose();
        return (s - support * test::leastSquares(support, s)).norm() / s.norm();
      };
      for (const int samples : {1, 2, 3, 5}) {
        const SelectionOptions options{.method = SelectionMethod::simultaneousPursuit,
                                       .samples = samples,
                                       .components = 8,
                                       .measurable = everything};
        double best = 1;
        for (unsigned subset = 1; subset < 256; ++subset)
          if (std::popcount(subset) == samples) best = std::min(best, residualOf(even, subset));
        QVERIFY(std::abs(selectSamples(even, options).residuals.back() - best) < 1e-6);
        if (samples > 1) continue;
        best = 1;
        for (unsigned i = 0; i < 8; ++i) best = std::min(best, residualOf(basis, 1U << i));
        QVERIFY(std::abs(selectSamples(basis, options).residuals.back() - best) < 1e-10);
      }
    }
  }

  /// Orthonormal training signals: whatever is chosen, each choice explains the same fraction.
  void residualsOfOrthonormalSignals() {
    const SampleSelection selection =
        selectSamples(randomBasis(200, 40, 10, 3),
                      {.method = SelectionMethod::simultaneousPursuit, .samples = 10, .measurable = everything});
    for (std::size_t k = 0; k < selection.residuals.size(); ++k)
      QVERIFY(std::abs(selection.residuals[k] - std::sqrt(1 - double(k) / 10)) < 1e-7);
  }

  void conditionOfTheChosenRows() {
    const auto basis = randomBasis(150, 30, 9, 5);
    const SampleSelection selection = selectSamples(
        basis,
        {.method = SelectionMethod::simultaneousPursuit, .samples = 6, .components = 9, .measurable = everything});
    Eigen::MatrixXd rows(6, 9);
    for (Eigen::Index i = 0; i < 6; ++i) {
      const auto at =
          std::find(basis.mapping.cells.begin(), basis.mapping.cells.end(), selection.cells[std::size_t(i)]);
      rows.row(i) = basis.svd.u.view().row(at - basis.mapping.cells.begin()).cast<double>();
    }
    rows *= basis.svd.singularValues.asDiagonal();
    const Eigen::VectorXd values = test::singularValues(rows);
    QVERIFY(std::abs(selection.conditionNumber - values[0] / values[5]) < 1e-10 * selection.conditionNumber);
  }

  void automaticIsTheMethodThatItNames() {
    const auto basis = randomBasis(300, 60, 40, 5);
    for (const auto& [samples, method] : {std::pair(mostAOptimalSamples, SelectionMethod::aOptimal),
                                          std::pair(mostAOptimalSamples + 1, SelectionMethod::simultaneousPursuit)}) {
      const SampleSelection automatic = selectSamples(basis, {.samples = samples, .measurable = everything});
      const SampleSelection named =
          selectSamples(basis, {.method = method, .samples = samples, .measurable = everything});
      QVERIFY(automatic.cells == named.cells && automatic.residuals == named.residuals);
      QCOMPARE(automatic.method, selectionMethodNames[std::size_t(method)]);
    }
  }

  void tellsEachChoiceAndProgress() {
    const auto basis = randomBasis(300, 30, 10, 4);
    std::vector<std::uint32_t> reported;
    double last = -1;
    const TaskControl control{.progress = [&](double fraction) {
      QVERIFY(fraction >= last && fraction <= 1);
      last = fraction;
    }};
    const SampleSelection selection =
        selectSamples(basis, {.method = SelectionMethod::simultaneousPursuit, .samples = 8}, control,
                      [&](std::uint32_t cell) { reported.push_back(cell); });
    QVERIFY(reported == selection.cells);
    QVERIFY(last == 1);
  }

  void cancelled() {
    std::stop_source source;
    int count = 0;
    const auto basis = randomBasis(300, 30, 10, 4);
    for (const SelectionMethod method : pursuits) {
      source = {};
      count = 0;
      QVERIFY_EXCEPTION_THROWN(selectSamples(basis, {.method = method, .samples = 8}, {.stop = source.get_token()},
                                             [&](std::uint32_t) {
                                               if (++count == 3) source.request_stop();
                                             }),
                               Cancelled);
      QCOMPARE(count, 3);
    }
  }
};

GONIO_TEST(SampleSelectionTest)
}  // namespace sample_selection_test

#include "sample_selection_test.moc"
