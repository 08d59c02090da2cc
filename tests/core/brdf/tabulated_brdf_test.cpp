// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/tabulated_brdf.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/support/error.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace tabulated_brdf_test {
using namespace gonio;

constexpr HalfDifferenceGrid smallGrid{7, 6, 10, true};

std::shared_ptr<const TabulatedBrdf> randomTable(const HalfDifferenceGrid& grid, double invalidFraction,
                                                 std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<TabulatedBrdf::Value> values(grid.size());
  std::vector<std::uint8_t> valid(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    values[i] = {uniform(random), uniform(random), uniform(random)};
    valid[i] = uniform(random) >= invalidFraction;
  }
  return std::make_shared<const TabulatedBrdf>(grid, values, valid);
}

HalfDifference randomCoordinates(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  return {halfPi * uniform(random), halfPi * uniform(random), pi * (2 * uniform(random) - 1), true};
}

/// Sums weights over all cells of the table: slow and plain.
Rgb bruteForce(const TabulatedBrdf& table, const HalfDifference& at, bool& valid) {
  const HalfDifferenceGrid& g = table.grid();
  const HalfDifferenceGrid::Position p = g.position(at);
  const auto tent = [](double distance) { return std::max(0.0, 1 - std::abs(distance)); };
  Rgb sum(0);
  double weightSum = 0;
  for (int i = 0; i < g.thetaHCount; ++i)
    for (int j = 0; j < g.thetaDCount; ++j)
      for (int k = 0; k < g.phiDCount; ++k) {
        const std::size_t cell = g.index(i, j, k);
        if (!table.valid()[cell]) continue;
        const double weight = tent(std::min(p.thetaH, g.thetaHCount - 1.0) - i) *
                              tent(std::min(p.thetaD, g.thetaDCount - 1.0) - j) *
                              tent(std::remainder(p.phiD - k, double(g.phiDCount)));
        sum += weight * Rgb(table.values()[cell]);
        weightSum += weight;
      }
  valid = weightSum > 0;
  return valid ? sum / weightSum : Rgb(0);
}

bool near(const Rgb& a, const Rgb& b, double tolerance) { return maxChannel(glm::abs(a - b)) <= tolerance; }

class TabulatedBrdfTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void nearestReadsTheNodes() {
    const auto table = randomTable({}, 0.2, 1);
    const HalfDifferenceGrid& grid = table->grid();
    for (std::size_t i = 0; i < grid.size(); i += 11) {
      // A little inside the cell that starts at the node: floors at exact edges are one rounding from the wrong cell.
      HalfDifference at = grid.node(i);
      at.thetaH += 1e-9, at.thetaD += 1e-9, at.phiD += 1e-9;
      bool valid = false;
      const Rgb value = table->lookup(at, TableLookup::cell, &valid);
      QCOMPARE(value, Rgb(table->values()[i]));
      QCOMPARE(valid, table->valid()[i] != 0);
    }
  }

  void trilinearIsExactAtNodes() {
    const auto table = randomTable({}, 0, 2);
    for (std::size_t i = 0; i < table->grid().size(); i += 13)
      QVERIFY(near(table->lookup(table->grid().node(i), TableLookup::trilinear), Rgb(table->values()[i]), 1e-12));
  }

  /// Linear in the grid coordinates (phi_d by a tent, so that it wraps): reproduced anywhere inside.
  void trilinearIsExactForLinearFunctions() {
    const HalfDifferenceGrid grid;
    std::vector<TabulatedBrdf::Value> values;
    const auto function = [](double h, double d, double f) { return Rgb(h, 2 * d + 1, std::abs(f - 90)) + Rgb(h + d); };
    for (std::size_t i = 0; i < grid.size(); ++i)
      values.emplace_back(function(double(i / 16200), double(i / 180 % 90), double(i % 180)));
    const TabulatedBrdf table(grid, values, std::vector<std::uint8_t>(grid.size(), 1));
    std::mt19937_64 random(3);
    for (int n = 0; n < 20000; ++n) {
      const HalfDifference at = randomCoordinates(random);
      const auto p = grid.position(at);
      if (p.thetaH > 89 || p.thetaD > 89) continue;
      QVERIFY(near(table.lookup(at, TableLookup::trilinear), function(p.thetaH, p.thetaD, p.phiD), 1e-9));
    }
  }

  void phiDWraps() {
    for (const bool reciprocal : {true, false}) {
      const auto table = randomTable({7, 6, 10, reciprocal}, 0, 4);
      const double period = table->grid().phiDPeriod();
      for (const double phi : {0.0, 0.3, 1.5, 3.0}) {
        const HalfDifference a{0.4, 0.6, phi, true}, b{0.4, 0.6, phi - period, true};
        QVERIFY(near(table->lookup(a, TableLookup::trilinear), table->lookup(b, TableLookup::trilinear), 1e-9));
      }
      const HalfDifference end{0.4, 0.6, period / 2 > pi / 2 ? -1e-12 : period - 1e-12, true}, start{0.4, 0.6, 0, true};
      QVERIFY(near(table->lookup(end, TableLookup::trilinear), table->lookup(start, TableLookup::trilinear), 1e-9));
    }
  }

  /// Tables without holes, with some and with many.
  void invalidCornersAreDropped() {
    std::mt19937_64 random(5);
    // More nodes of phi_d than one word of interior bits has.
    const HalfDifferenceGrid wideGrid{.thetaHCount = 5, .thetaDCount = 4, .phiDCount = 150};
    for (const auto& [grid, invalidFraction] : {std::pair{smallGrid, 0.0},
                                                {smallGrid, 0.1},
                                                {smallGrid, 0.5},
                                                {smallGrid, 0.9},
                                                {smallGrid, 1.0},
                                                {wideGrid, 0.1}}) {
      const auto table = randomTable(grid, invalidFraction, 6);
      for (int n = 0; n < 5000; ++n) {
        const HalfDifference at = randomCoordinates(random);
        bool valid = false, expectedValid = false;
        const Rgb value = table->lookup(at, TableLookup::trilinear, &valid);
        const Rgb expected = bruteForce(*table, at, expectedValid);
        QCOMPARE(valid, expectedValid);
        QVERIFY(near(value, expected, 1e-12));
      }
    }
  }

  void allInvalidGivesZeroAndTellsSo() {
    const auto table = randomTable(smallGrid, 2, 7);
    bool valid = true;
    QCOMPARE(table->lookup({0.3, 0.4, 0.5, true}, TableLookup::trilinear, &valid), Rgb(0));
    QVERIFY(!valid);
    QCOMPARE(table->lookup({0.3, 0.4, 0.5, true}, TableLookup::cell, &valid), Rgb(0));
    QVERIFY(!valid);
    QCOMPARE(table->validCount(), std::size_t(0));
  }

  void dataIsAboveTheHorizonWhereCellsAreValid() {
    const Direction up(0, 0, 1), below = fromSpherical(1.8, 0);
    const auto full = randomTable(smallGrid, 0, 7), none = randomTable(smallGrid, 2, 7);
    QVERIFY(full->hasData({up, up}) && !full->hasData({below, up}) && !full->hasData({up, below}));
    QVERIFY(!none->hasData({up, up}));
    QCOMPARE(formOf<TabulatedBrdf>(*full), full.get());
    const test::FunctionBrdf model = test::lambert(Rgb(0));
    QVERIFY(model.hasData({up, up}) && !model.hasData({up, below}) && !formOf<TabulatedBrdf>(model));
  }

  /// A long batch, its remainder and single pairs take different ways through the code.
  void batchAndSinglePairsHaveTheSameBits() {
    const auto table = randomTable({}, 0.05, 8);
    std::mt19937_64 random(9);
    std::vector<DirectionPair> pairs;
    for (int n = 0; n < 1001; ++n) pairs.push_back({test::randomUpper(random), test::randomUpper(random)});
    pairs[3].wi.z = -0.5;
    std::vector<Rgb> values(pairs.size());
    for (const TableLookup mode : {TableLookup::cell, TableLookup::trilinear}) {
      table->evaluate(pairs, values, mode);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        Rgb one(0);
        table->evaluate(std::span(&pairs[i], 1), std::span(&one, 1), mode);
        QVERIFY(one == values[i]);
        if (i != 3) QVERIFY(one == table->lookup(toHalfDifference(pairs[i].wi, pairs[i].wo), mode));
      }
      QCOMPARE(values[3], Rgb(0));
    }
  }

  void foldedTablesAreReciprocal() {
    const auto table = randomTable({}, 0.05, 10);
    std::mt19937_64 random(11);
    for (int n = 0; n < 10000; ++n) {
      const Direction wi = test::randomUpper(random), wo = test::randomUpper(random);
      QVERIFY(near(table->evaluate(wi, wo), table->evaluate(wo, wi), 1e-9));
    }
  }

  void hardCase1GrazingDirections() {
    const auto table = bakeTable(*test::ggx(Rgb(0.3), Rgb(1), 0.1, 0.04));
    for (const double z : {0.0, -1e-17, 1e-17, 1e-8})
      for (const double phi : {0.0, 1.0, 2.0, 3.1, pi}) {
        const Direction grazing{std::cos(phi), std::sin(phi), z};
        for (const Direction& other : {Direction{0, 0, 1}, Direction{1, 0, 0}, Direction{0.6, 0, 0.8}}) {
          const Rgb value = table->evaluate(grazing, other);
          for (int channel = 0; channel < 3; ++channel) QVERIFY(std::isfinite(value[channel]) && value[channel] >= 0);
        }
      }
  }

  void hardCase2SlightlyBelowTheHorizonIsTheHorizon() {
    const auto table = randomTable({}, 0, 12);
    const Direction other{0.6, 0, 0.8};
    for (const double z : {-1e-16, -9e-13}) {
      QVERIFY(near(table->evaluate({1, 0, z}, other), table->evaluate({1, 0, 0}, other), 1e-9));
      QVERIFY(near(table->evaluate(other, {0, 1, z}), table->evaluate(other, {0, 1, 0}), 1e-9));
    }
    QCOMPARE(table->evaluate({1, 0, -1e-9}, other), Rgb(0));
    QCOMPARE(table->evaluate(other, {1, 0, std::numeric_limits<double>::quiet_NaN()}), Rgb(0));
  }

  void hardCase3RetroReflectionIsContinuous() {
    const auto table = bakeTable(*test::ggx(Rgb(0.3), Rgb(1), 0.3, 0.5));
    std::mt19937_64 random(13);
    for (int n = 0; n < 1000; ++n) {
      const Direction wi = test::randomUpper(random);
      if (wi.z < 0.1) continue;
      const Direction beside = glm::normalize(wi + Direction(1e-9, 5e-10, 0));
      QVERIFY(near(table->evaluate(wi, wi), table->evaluate(wi, beside), 1e-6));
    }
  }

  void hardCase4OppositeDirectionsGiveZero() {
    const auto table = randomTable({}, 0, 14);
    QCOMPARE(table->evaluate({1, 0, 0}, {-1, 0, 0}), Rgb(0));
  }

  void hardCase5MirrorPairs() {
    const auto table = bakeTable(*test::ggx(Rgb(0), Rgb(1), 0.1, 0.5));
    for (double theta = 0; theta < 1.4; theta += 0.1)
      for (const double phi : {0.0, 0.5, 1.5707963, 3.0, -2.0}) {
        const Direction wi = fromSpherical(theta, phi), wo{-wi.x, -wi.y, wi.z};
        QVERIFY(near(table->evaluate(wi, wo), table->evaluate(wo, wi), 1e-9));
        QVERIFY(
            std::abs(table->evaluate(wi, wo).x / table->evaluate(fromSpherical(theta, 0), fromSpherical(theta, pi)).x -
                     1) < 1e-3);
      }
  }

  void hardCase11NegativeValues() {
    std::vector<TabulatedBrdf::Value> values(smallGrid.size(), TabulatedBrdf::Value(0.5f));
    std::vector<std::uint8_t> valid(smallGrid.size(), 1);
    values[5] = TabulatedBrdf::Value(-1.0f / 1500, 0.25f, -0.0f);
    values[6] = TabulatedBrdf::Value(-1);
    valid[6] = 0;
    const TabulatedBrdf table(smallGrid, values, valid);
    QCOMPARE(table.validCount(), smallGrid.size() - 1);
    QCOMPARE(table.clampedCount(), std::size_t(1));
    QCOMPARE(table.values()[5], TabulatedBrdf::Value(0, 0.25f, 0));
    QVERIFY(!std::signbit(table.values()[5].z));
    QCOMPARE(table.values()[6], TabulatedBrdf::Value(0));
  }

  void hardCase42NotFiniteIsRefusedWithItsCell() {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
      std::vector<TabulatedBrdf::Value> values(smallGrid.size(), TabulatedBrdf::Value(0.5f));
      std::vector<std::uint8_t> valid(smallGrid.size(), 1);
      values[smallGrid.index(3, 2, 7)].y = bad;
      values[smallGrid.index(5, 0, 0)].x = bad;
      QVERIFY_THROWS_EXCEPTION(Error, TabulatedBrdf(smallGrid, values, valid));
      try {
        const TabulatedBrdf table(smallGrid, values, valid);
      } catch (const Error& error) {
        QVERIFY(QString(error.what()).contains("(theta_h 3, theta_d 2, phi_d 7)"));
      }
      // In invalid cells anything may stand.
      valid[smallGrid.index(3, 2, 7)] = valid[smallGrid.index(5, 0, 0)] = 0;
      QCOMPARE(TabulatedBrdf(smallGrid, values, valid).validCount(), smallGrid.size() - 2);
    }
  }

  void wrongSizesAreRefused() {
    using Values = std::vector<TabulatedBrdf::Value>;
    QVERIFY_THROWS_EXCEPTION(Error, TabulatedBrdf(smallGrid, Values(3), std::vector<std::uint8_t>(smallGrid.size())));
    QVERIFY_THROWS_EXCEPTION(Error, TabulatedBrdf(smallGrid, Values(smallGrid.size()), std::vector<std::uint8_t>(3)));
  }
};

GONIO_TEST(TabulatedBrdfTest)
}  // namespace tabulated_brdf_test

#include "tabulated_brdf_test.moc"
