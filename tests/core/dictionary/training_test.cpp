// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/training.h"

#include <QTest>

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
