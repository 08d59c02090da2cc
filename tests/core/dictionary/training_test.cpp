// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/training.h"

#include <QTest>
#include <algorithm>
#include <functional>
#include <numeric>

#include "core/dictionary/alternatives/full_sweep.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/test_program.h"

namespace training_test {
using namespace gonio;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

const TrainingOptions options{.dictionaries = 3, .sparsities = {8, 20}, .iterations = 6, .tolerance = 0};

void verifySameBits(const Ensemble& a, const Ensemble& b) {
  QCOMPARE(a.dictionaries.size(), b.dictionaries.size());
  for (std::size_t d = 0; d < a.dictionaries.size(); ++d)
    for (std::size_t mode = 0; mode < 3; ++mode)
      QVERIFY(a.dictionaries[d].modes[mode] == b.dictionaries[d].modes[mode]);
}

class TrainingTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void learnsOrthonormalDictionaries() {
    const TrainingMaterials materials = ggxMaterials(8);
    std::vector<double> progress;
    const TrainingResult result =
        train(materials, options, {.stop = {}, .progress = [&](double fraction) { progress.push_back(fraction); }});
    QVERIFY(result.complete);
    QCOMPARE(result.ensemble.dictionaries.size(), std::size_t(6));
    QCOMPARE(result.ensemble.dictionaries[0].sparsity, 8);
    QCOMPARE(result.ensemble.dictionaries[5].sparsity, 20);
    QCOMPARE(result.ensemble.learnedFrom.size(), std::size_t(8));
    QVERIFY(orthonormalityError(result.ensemble) < 1e-10);
    for (const std::vector<double>& errors : result.state.errors)
      for (std::size_t i = 1; i < errors.size(); ++i) QVERIFY(errors[i] <= errors[i - 1] * (1 + 1e-5));
    QVERIFY(std::is_sorted(progress.begin(), progress.end()));
    QVERIFY(progress.back() <= 1);
  }

  /// What the subspace leaves out is learned by the sweep in the whole space.
  void fullSweepLowersTheErrors() {
    TrainingOptions coarse = options;
    coarse.subspaceLoss = 0.02;
    const TrainingResult result = train(ggxMaterials(8), coarse);
    QVERIFY(result.state.subspace.loss > 1e-4 && result.state.subspace.loss <= 0.02);
    for (std::size_t mode = 0; mode < 3; ++mode)
      QVERIFY(result.state.subspace.ranks[mode] < modeSizes(smallGrid)[mode]);
    for (std::size_t e = 0; e < 2; ++e) QVERIFY(result.errorsAfter[e] < result.errorsBefore[e]);
    QVERIFY(orthonormalityError(result.ensemble) < 1e-10);
  }

  /// What is learned from, by brute force: the signals of reciprocal materials, and those of both orders over the whole
  /// circle, which have half of the energy, in the cosine-log alone; with `normalised` all have the same energy.
  void errorsAreThoseOfAllSignals_data() {
    QTest::addColumn<bool>("normalised");
    QTest::newRow("as they are") << false;
    QTest::newRow("normalised") << true;
  }
  void errorsAreThoseOfAllSignals() {
    QFETCH(bool, normalised);
    TrainingMaterials materials = ggxMaterials(2);
    const auto tables = std::array{materials.load(0), materials.load(1), oneWayTable()};
    materials.names.push_back("one way");
    materials.load = [&](std::size_t m) { return tables[m]; };
    TrainingOptions one{.dictionaries = 1, .sparsities = {12}, .iterations = 3, .tolerance = 0};
    one.signals.normalised = normalised;
    const TrainingResult result = train(materials, one);
    const Dictionary& learned = result.ensemble.dictionaries.at(0);
    double left = 0, total = 0;
    for (const auto& table : tables)
      for (const DataTransform transform : one.signals.transforms) {
        const bool isReciprocal = table->isReciprocal();
        if (!isReciprocal && transform != DataTransform::cosineLog) continue;
        const auto modes = isReciprocal ? learned.modes : inBothOrders(learned).modes;
        for (const Eigen::ArrayXd& signal : signalsOf(*table, transform, *GridGeometry::of(table->grid()))) {
          factorization::Tensor projection = tensorOf(signal.data(), modeSizes(table->grid()));
          for (int mode = 0; mode < 3; ++mode)
            projection = factorization::transposedModeProduct(projection, modes[std::size_t(mode)], mode);
          std::vector<double> squares;
          for (std::size_t i = 0; i < projection.count(); ++i) squares.push_back(projection[i] * projection[i]);
          std::ranges::sort(squares, std::greater<>());
          const double energy = signal.square().sum();
          const double weight = normalised ? 1 / energy : isReciprocal ? 1 : 0.5;
          left += weight * std::accumulate(squares.begin() + 12, squares.end(), 0.0);
          total += weight * energy;
        }
      }
    QVERIFY(left > 1e-6 * total);
    QVERIFY(std::abs(result.errorsAfter.at(0) / (left / total) - 1) < 1e-9);
  }

  /// Those of the first ensemble keep their numbers.
  void joinedEnsembles() {
    Ensemble first = randomEnsemble(2), second = randomEnsemble(3);
    first.learnedFrom = {"a", "b"};
    second.learnedFrom = {"b", "c"};
    const Ensemble both = joined(first, second);
    QCOMPARE(both.dictionaries.size(), std::size_t(5));
    QVERIFY(both.dictionaries[1].modes[0] == first.dictionaries[1].modes[0]);
    QVERIFY(both.dictionaries[4].modes[2] == second.dictionaries[2].modes[2]);
    QVERIFY((both.learnedFrom == std::vector<std::string>{"a", "b", "c"}));
    second.scaled = false;
    QVERIFY_EXCEPTION_THROWN(joined(first, second), Error);
    second = inBothOrders(randomEnsemble(1));
    QVERIFY_EXCEPTION_THROWN(joined(first, second), Error);
  }

  void resumesWithTheSameBits() {
    const TrainingMaterials materials = ggxMaterials(6);
    std::vector<TrainingState> states;
    const TrainingResult whole =
        train(materials, options, {}, nullptr, [&](const TrainingState& state) { states.push_back(state); });
    QCOMPARE(states.size(), std::size_t(12));
    for (const std::size_t from : {2, 5, 9, 11}) {
      const TrainingResult resumed = train(materials, options, {}, &states[from]);
      verifySameBits(resumed.ensemble, whole.ensemble);
    }
  }

  void stopGivesTheBestSoFar() {
    const TrainingMaterials materials = ggxMaterials(6);
    std::stop_source stop;
    int rounds = 0;
    const TrainingResult result =
        train(materials, options, {.stop = stop.get_token(), .progress = {}}, nullptr, [&](const TrainingState&) {
          if (++rounds == 8) stop.request_stop();
        });
    QVERIFY(!result.complete);
    QCOMPARE(result.state.errors.size(), std::size_t(2));
    QCOMPARE(result.ensemble.dictionaries.size(), std::size_t(6));
    QVERIFY(orthonormalityError(result.ensemble) < 1e-10);

    std::stop_source early;
    early.request_stop();
    QVERIFY_EXCEPTION_THROWN(train(materials, options, {.stop = early.get_token(), .progress = {}}), Cancelled);
    QVERIFY_EXCEPTION_THROWN(train({}, options), Error);
  }

  /// A held value continues the material: it leaves no jump at the horizon.
  void fillLeavesNoCliff() {
    const auto table = ggxMaterials(1).load(0);
    const auto geometry = GridGeometry::of(smallGrid);
    const auto held = signalsOf(*table, DataTransform::logPlus, *geometry);
    const std::size_t slab = std::size_t(smallGrid.thetaDCount) * std::size_t(smallGrid.phiDCount);
    std::size_t invalid = 0;
    for (std::size_t cell = slab; cell < smallGrid.size(); ++cell) {
      const auto i = Eigen::Index(cell), before = Eigen::Index(cell - slab);
      if (table->valid()[cell] != 0) {
        const double y = double(held[0][i]) / cellScalingOf(smallGrid, *geometry, cell);
        QVERIFY(std::abs(y - std::log1p(double(table->values()[cell].x))) < 1e-6);
        continue;
      }
      ++invalid;
      QVERIFY(std::abs(double(held[0][i]) / cellScalingOf(smallGrid, *geometry, cell) -
                       double(held[0][before]) / cellScalingOf(smallGrid, *geometry, cell - slab)) < 1e-6);
    }
    QVERIFY(invalid > 100);
  }

  /// Its square is the cells' measure times cos^2 theta_h cos^2 theta_d, but for the floor where that is small.
  void cellScalingIsThatOfProjectedSolidAngles() {
    const HalfDifferenceGrid grid;
    const auto geometry = GridGeometry::of(grid);
    for (const Eigen::ArrayXd& mode : geometry->cellScaling) {
      QVERIFY(std::abs(mode.square().mean() - 1) < 1e-12);
      QVERIFY(mode.minCoeff() >= 0.0999 * mode.maxCoeff());
    }
    const auto ratio = [&](int i, int j) {
      const std::size_t cell = grid.index(i, j, 7);
      const HalfDifference node = grid.node(cell);
      const double cosines = std::cos(node.thetaH) * std::cos(node.thetaD);
      return std::pow(cellScalingOf(grid, *geometry, cell), 2) / (grid.cellMeasure(cell) * cosines * cosines);
    };
    for (int i = 25; i <= 80; i += 5)
      for (int j = 10; j <= 60; j += 5) QVERIFY(std::abs(ratio(i, j) / ratio(50, 30) - 1) < 0.01);
    QVERIFY(ratio(2, 30) > 10 * ratio(50, 30));  // the floor
  }
};

GONIO_TEST(TrainingTest)
}  // namespace training_test

#include "training_test.moc"
