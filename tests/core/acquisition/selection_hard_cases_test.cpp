// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <array>
#include <set>

#include "core/acquisition/sample_selection.h"
#include "core/support/error.h"
#include "tests/core/acquisition/selection_test_support.h"
#include "tests/support/test_program.h"

namespace selection_hard_cases_test {
using namespace gonio;
using namespace gonio::acquisition;
using namespace gonio::acquisition::test_support;

constexpr SelectionMethod allMethods[] = {SelectionMethod::simultaneousPursuit,
                                          SelectionMethod::simultaneousPursuitFirstColumns,
                                          SelectionMethod::simultaneousPursuitUnnormalised,
                                          SelectionMethod::conditionNumber,
                                          SelectionMethod::random,
                                          SelectionMethod::uniform,
                                          SelectionMethod::aOptimal};
constexpr SelectionMethod pursuits[] = {SelectionMethod::simultaneousPursuit,
                                        SelectionMethod::simultaneousPursuitFirstColumns,
                                        SelectionMethod::simultaneousPursuitUnnormalised};

/// The text of the error; empty when there is none.
QString errorOf(const dictionary::PrincipalComponents& basis, const SelectionOptions& options) {
  try {
    selectSamples(basis, options);
  } catch (const Error& e) {
    return e.what();
  }
  return {};
}

std::vector<std::uint32_t> sorted(std::vector<std::uint32_t> cells) {
  std::sort(cells.begin(), cells.end());
  return cells;
}

class SelectionHardCasesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Rows of the dictionary that are 0 are never chosen, and nothing becomes a NaN.
  void hardCase21ZeroColumns() {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      Eigen::MatrixXd u = orthonormalColumns(60, 8, seed);
      for (Eigen::Index i = 0; i < u.rows(); i += 2) u.row(i).setZero();
      const auto basis = basisOf(u, orthonormalColumns(30, 8, 40 + seed));
      for (const SelectionMethod method : pursuits) {
        const SampleSelection selection =
            selectSamples(basis, {.method = method, .samples = 8, .measurable = everything});
        QCOMPARE(selection.cells.size(), std::size_t(8));
        for (const std::uint32_t cell : selection.cells) {
          const auto at = std::find(basis.mapping.cells.begin(), basis.mapping.cells.end(), cell);
          QCOMPARE((at - basis.mapping.cells.begin()) % 2, std::ptrdiff_t(1));
        }
        for (const double residual : selection.residuals) QVERIFY(std::isfinite(residual));
        QVERIFY(std::isfinite(selection.conditionNumber));
      }
    }
    const auto zero = basisOf(Eigen::MatrixXd::Zero(60, 8), orthonormalColumns(30, 8, 1));
    const SampleSelection none =
        selectSamples(zero, {.method = SelectionMethod::simultaneousPursuit, .samples = 3, .measurable = everything});
    QVERIFY(none.cells.empty() && !none.warning.empty());
  }

  /// Every row stands several times, of any length and sign: the first of each is chosen, and none twice.
  void hardCase22DuplicatesAndCollinear() {
    for (unsigned seed = 1; seed <= 10; ++seed) {
      const Eigen::MatrixXd few = orthonormalColumns(25, 8, seed);
      Eigen::MatrixXd u(75, 8);
      for (Eigen::Index i = 0; i < 75; ++i) u.row(i) = few.row(i % 25);
      const auto v = orthonormalColumns(30, 8, 40 + seed);
      const SelectionOptions options{
          .method = SelectionMethod::simultaneousPursuit, .samples = 8, .measurable = everything};
      const SampleSelection selection = selectSamples(basisOf(u, v), options);
      QCOMPARE(selection.cells, selectSamples(basisOf(few, v), options).cells);  // the lowest index of equals
      for (Eigen::Index i = 25; i < 75; ++i) u.row(i) *= i < 50 ? -2 : 0.25;
      const auto basis = basisOf(u, v);
      const SampleSelection scaled = selectSamples(basis, options);
      QCOMPARE(scaled.cells, selection.cells);
      QCOMPARE(scaled.cells.size(), std::size_t(8));
      QVERIFY(isDistinctAmong(scaled.cells, basis.mapping.cells));
      QVERIFY(scaled.conditionNumber < 1e8);
    }
  }

  void hardCase23MoreSamplesThanComponents() {
    const auto basis = randomBasis(200, 30, 6, 3);
    for (const SelectionMethod method : pursuits)
      for (const int components : {0, 4, 6, 100}) {
        const SampleSelection selection =
            selectSamples(basis, {.method = method, .samples = 20, .components = components, .measurable = everything});
        QCOMPARE(selection.cells.size(), std::size_t(components == 4 ? 4 : 6));
        QVERIFY(selection.residuals.back() <= 1e-10);
        QVERIFY(selection.warning.find("of 20") != std::string::npos);
      }
    QVERIFY(
        selectSamples(basis, {.method = SelectionMethod::simultaneousPursuit, .samples = 6, .measurable = everything})
            .warning.empty());
  }

  /// Atoms that span fewer dimensions than there are components: as many are chosen as are independent.
  void dependentRows() {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const Eigen::MatrixXd u = randomMatrix(60, 3, seed) * randomMatrix(3, 8, 20 + seed);
      const auto basis = basisOf(u, orthonormalColumns(30, 8, 40 + seed));
      // Single precision makes its rows independent again, in the eighth digit.
      auto exact = basis;
      for (float& value : exact.svd.u.values) value = std::round(value * 64) / 64;
      const Eigen::MatrixXf integers = (randomMatrix(60, 3, seed) * 4).array().round().matrix().cast<float>() *
                                       (randomMatrix(3, 8, 20 + seed) * 4).array().round().matrix().cast<float>();
      Eigen::Map<Eigen::MatrixXf>(exact.svd.u.values.data(), 60, 8) = integers;
      for (const SelectionMethod method : pursuits) {
        const SampleSelection selection =
            selectSamples(exact, {.method = method, .samples = 8, .measurable = everything});
        QCOMPARE(selection.cells.size(), std::size_t(3));
        QVERIFY(!selection.warning.empty());
        QVERIFY(std::isfinite(selection.conditionNumber) && selection.conditionNumber < 1e8);
      }
    }
  }

  /// Signals of fewer dimensions than the components: chosen until they are explained.
  void dependentSignals() {
    const Eigen::MatrixXd v = randomMatrix(40, 1, 1) * randomMatrix(1, 8, 2);
    Eigen::MatrixXd u = orthonormalColumns(50, 8, 3);
    auto basis = basisOf(u, v);
    // A cell that depends on exactly this one direction.
    Eigen::Map<Eigen::MatrixXf>(basis.svd.u.values.data(), 50, 8).row(20) =
        (v.row(0).cwiseProduct(basis.svd.singularValues.transpose()) * 1e-3).cast<float>();
    const SampleSelection selection =
        selectSamples(basis, {.method = SelectionMethod::simultaneousPursuit, .samples = 8, .measurable = everything});
    QCOMPARE(selection.cells.front(), basis.mapping.cells[20]);
    QVERIFY(selection.residuals[1] < 1e-6);
  }

  /// Materials that are all the same have no components: nothing to learn from, but random and uniform need nothing.
  void hardCase14NoComponents() {
    const auto basis = basisOf(Eigen::MatrixXd(60, 0), Eigen::MatrixXd(30, 0));
    for (const SelectionMethod method : allMethods) {
      const SelectionOptions options{.method = method, .samples = 3, .measurable = everything};
      if (method == SelectionMethod::random || method == SelectionMethod::uniform)
        QCOMPARE(selectSamples(basis, options).cells.size(), std::size_t(3));
      else
        QVERIFY(errorOf(basis, options).contains("no principal components"));
    }
  }

  /// Every cell chosen is one that the rig can see, although the best ones may not be.
  void forbiddenRegions() {
    const auto basis = randomBasis(500, 30, 8, 6);
    const auto best =
        selectSamples(basis, {.method = SelectionMethod::simultaneousPursuit, .samples = 8, .measurable = everything})
            .cells;
    MeasurableDirections rig{.maxPolarAngle = radians(60), .minSeparation = radians(15)};
    rig.forbidden.push_back({.thetaI = {0, radians(30)}});
    const auto allowed = measurableCells(basis, rig);
    QVERIFY(allowed.size() > 20 && allowed.size() < basis.mapping.cells.size());
    QCOMPARE(allSelectedCells(basis, rig), allowed);
    for (const SelectionMethod method : allMethods) {
      const SampleSelection selection = selectSamples(basis, {.method = method, .samples = 8, .measurable = rig});
      QCOMPARE(selection.cells.size(), std::size_t(8));
      QVERIFY(isDistinctAmong(selection.cells, allowed));
      QVERIFY(sorted(selection.cells) != sorted(best));
    }
  }

  /// All cells of theta_d = 0 and of theta_h = 0 that differ in phi_d are one pair of directions: a plan of all that
  /// can be measured holds no pair twice, and each sample is read at the cell that was chosen.
  void pairsOnce() {
    const auto basis = basisOf(orthonormalColumns(250, 8, 1), orthonormalColumns(30, 8, 2), smallGrid, 1, true);
    const HalfDifferenceGrid& grid = basis.mapping.grid;
    for (const SelectionMethod method : allMethods) {
      const auto cells = selectSamples(basis, {.method = method, .samples = 8, .measurable = everything}).cells;
      for (const std::uint32_t cell : cells) QCOMPARE(nearestNode(grid, grid.directions(cell)), cell);
    }
    const auto all = allSelectedCells(basis, everything);
    std::set<std::array<long, 4>> pairs;
    for (const std::uint32_t cell : all) {
      const auto [wi, wo] = grid.directions(cell);
      const auto rounded = [](double x) { return std::lround(1e6 * x); };
      // What a turn about the normal does not change.
      pairs.insert(
          {rounded(wi.z), rounded(wo.z), rounded(wi.x * wo.x + wi.y * wo.y), rounded(wi.x * wo.y - wi.y * wo.x)});
      QCOMPARE(nearestNode(grid, grid.directions(cell)), cell);
    }
    QCOMPARE(pairs.size(), all.size());
    QVERIFY(all.size() < basis.mapping.cells.size() - 60);
  }

  void fewerCellsThanSamples() {
    const auto basis = randomBasis(6, 30, 4, 2);
    for (const SelectionMethod method : {SelectionMethod::conditionNumber, SelectionMethod::random,
                                         SelectionMethod::uniform, SelectionMethod::aOptimal}) {
      const SampleSelection selection =
          selectSamples(basis, {.method = method, .samples = 9, .measurable = everything});
      QCOMPARE(sorted(selection.cells), basis.mapping.cells);
      QVERIFY(selection.warning.find("9") != std::string::npos);
    }
  }

  void refusals() {
    const auto basis = randomBasis(100, 30, 8, 6);
    MeasurableDirections nothing;
    nothing.forbidden.emplace_back();
    for (const SelectionMethod method : allMethods) {
      QVERIFY(errorOf(basis, {.method = method, .measurable = nothing}).contains("no direction pair can be measured"));
      QVERIFY(errorOf(basis, {.method = method, .samples = 0}).contains("0 samples"));
      QVERIFY(errorOf(basis, {.method = method, .samples = -3}).contains("-3 samples"));
      QVERIFY(errorOf(basis, {.method = method, .components = -1}).contains("-1 components"));
      QVERIFY(errorOf(basis, {.method = method, .measurable = {.maxPolarAngle = 2}}).contains("maximum polar angle"));
    }
  }
};

GONIO_TEST(SelectionHardCasesTest)
}  // namespace selection_hard_cases_test

#include "selection_hard_cases_test.moc"
