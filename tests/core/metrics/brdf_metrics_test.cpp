// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/brdf_metrics.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "core/brdf/utia_brdf.h"
#include "core/coordinates/grid_directions.h"
#include "core/materials/material.h"
#include "core/math/parallel.h"
#include "core/math/types.h"
#include "core/models/registry.h"
#include "core/support/error.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace brdf_metrics_test {
using namespace gonio;
using namespace gonio::metrics;

using Values = std::vector<TabulatedBrdf::Value>;
using Flags = std::vector<std::uint8_t>;

/// Every cell above the horizon holds `value`.
TabulatedBrdf constantTable(double value, const HalfDifferenceGrid& grid = {}) {
  return *bakeTable(test::FunctionBrdf([&](const Direction&, const Direction&) { return Rgb(value); }), grid);
}

constexpr double gammaOfTests = 1.7;

/// Textbook CIE 1976 L*a*b* of a grey whose reflectance factor is y: a* = b* = 0.
double greyLightness(double y) { return 116 * (y > 216.0 / 24389 ? std::cbrt(y) : (24389.0 / 27 * y + 16) / 116) - 16; }

/// What a metric sums for one channel of one cell, written out one by one.
double plainTerm(BrdfMetric metric, double a, double b, double cosI, double cosO) {
  const double x = a * cosI, y = b * cosI;
  const double cosines = std::max(cosI * cosO, 1e-3), u = a * cosines, v = b * cosines;
  const double relative = std::log((u + 1e-3) / (v + 1e-3));
  switch (metric) {
    case BrdfMetric::log:
      return std::pow(std::log(1 + x) - std::log(1 + y), 2);
    case BrdfMetric::cosineL2:
      return std::pow(x - y, 2);
    case BrdfMetric::cubeRoot:
      return std::pow(std::pow(x, 1.0 / 3) - std::pow(y, 1.0 / 3), 2);
    case BrdfMetric::meanAbsoluteLog:
      return std::abs(std::log(1 + x) - std::log(1 + y));
    case BrdfMetric::bieronPeersLog:
      return cosO * std::pow(std::log(1 + x) - std::log(1 + y), 2);
    case BrdfMetric::gamma:
      return std::pow(std::pow(x, 1 / gammaOfTests) - std::pow(y, 1 / gammaOfTests), 2);
    case BrdfMetric::logRelative:
      return relative * relative;
    case BrdfMetric::rms:
      return std::pow(a - b, 2);
    case BrdfMetric::cosineCubeRoot:
      return std::pow(std::abs(x - y), 2.0 / 3);
    case BrdfMetric::projectedRms:
      return cosO * std::pow(a - b, 2);
    case BrdfMetric::meanAbsolute:
      return std::abs(a - b);
    case BrdfMetric::cosinesCubeRoot:
      return std::pow(std::abs(u - v), 2.0 / 3);
    case BrdfMetric::meanAbsoluteLogRelative:
      return std::abs(relative);
    default:  // lab, of greys: all of it in one channel's share
      return cosI * cosO * std::pow(greyLightness(pi * a) - greyLightness(pi * b), 2) / 3;
  }
}

double plainWeight(BrdfMetric metric, double cosI, double cosO) {
  if (metric == BrdfMetric::bieronPeersLog || metric == BrdfMetric::projectedRms) return cosO;
  return metric == BrdfMetric::lab ? cosI * cosO / 3 : 1;
}

/// The definition, cell by cell with the grid's own methods.
double plainError(BrdfMetric metric, const TabulatedBrdf& reference, const Brdf& test, double maxPolarAngle) {
  double sum = 0, weightSum = 0;
  for (std::size_t i = 0; i < reference.grid().size(); ++i) {
    if (!reference.valid()[i] || !reference.grid().nodeWithin(i, maxPolarAngle)) continue;
    const auto [wi, wo] = reference.grid().directions(i);
    const double measure = reference.grid().cellMeasure(i);
    const Rgb value = test.evaluate(wi, wo);
    for (int channel = 0; channel < 3; ++channel) {
      sum += measure * plainTerm(metric, reference.values()[i][channel], value[channel], wi.z, wo.z);
      weightSum += measure * plainWeight(metric, wi.z, wo.z);
    }
  }
  const bool isRoot = metric != BrdfMetric::meanAbsoluteLog && metric != BrdfMetric::meanAbsolute &&
                      metric != BrdfMetric::cosinesCubeRoot && metric != BrdfMetric::meanAbsoluteLogRelative;
  return isRoot ? std::sqrt(sum / weightSum) : sum / weightSum;
}

/// Every cell, and every channel, times `factor`.
TabulatedBrdf scaled(const TabulatedBrdf& table, float factor) {
  Values values(table.values().begin(), table.values().end());
  for (auto& value : values) value *= factor;
  return {table.grid(), std::move(values), Flags(table.valid().begin(), table.valid().end())};
}

class BrdfMetricsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void agreesWithTheDefinition() {
    const HalfDifferenceGrid grid{36, 18, 36, true};  // has nodes at exactly 60, 80 and 85 degrees
    for (const bool isGrey : {false, true}) {
      const auto table = bakeTable(*test::ggx(isGrey ? Rgb(0.3) : Rgb(0.3, 0.1, 0), Rgb(1), 0.2, 0.3), grid);
      const auto test = test::ggx(isGrey ? Rgb(0.2) : Rgb(0.25, 0.2, 0.1), Rgb(0.8), 0.25, 0.3);
      for (const double angle : {60.0, 80.0, 85.0}) {
        const std::vector<double> errors = brdfErrors(*table, *test, radians(angle), gammaOfTests);
        QCOMPARE(errors.size(), metricRecords().size());
        for (const BrdfMetric metric : allBrdfMetrics()) {
          const double error = errors[std::size_t(metric)];
          QCOMPARE(brdfError(metric, *table, *test, radians(angle), gammaOfTests), error);
          if (metric == BrdfMetric::lab && !isGrey) continue;
          const double expected = plainError(metric, *table, *test, radians(angle));
          QVERIFY2(std::abs(error / expected - 1) < 1e-9,
                   qPrintable(QString("%1: %2, %3").arg(metricId(metric).data()).arg(error).arg(expected)));
        }
      }
    }
  }

  /// Close values, and ones of very different size.
  void differencesOfAllSizes() {
    const HalfDifferenceGrid grid{9, 6, 12, true};
    for (const auto& [a, b] : {std::pair{0.25, 0.25 * (1 + 1e-6)},
                               {0.25 * (1 + 1e-6), 0.25},
                               {0.0, 1e12},
                               {1e12, 0.0},
                               {1e12, 1e12 * (1 + 1e-6)},
                               {1e-12, 2e-12},
                               {0.0, 1e-30},
                               {1e25, 1e20},
                               {1e38, 3.4e38},
                               {3.4e38, 1e38}}) {
      const TabulatedBrdf reference = constantTable(double(float(a)), grid);
      const double ratio = a == 0 ? 0 : b / a, value = a == 0 ? b : reference.values()[0].x * ratio;
      const test::FunctionBrdf test([&](const Direction&, const Direction&) { return Rgb(value); });
      const std::vector<double> errors = brdfErrors(reference, test, defaultMaxPolarAngle, gammaOfTests);
      for (const BrdfMetric metric : allBrdfMetrics()) {
        const double error = errors[std::size_t(metric)];
        const double expected = plainError(metric, reference, test, defaultMaxPolarAngle);
        // The definition itself subtracts rounded logarithms and roots.
        const double rounding = 1e-15 * std::max({1.0, a, b});
        QVERIFY2(std::abs(error - expected) < 1e-9 * expected + rounding, qPrintable(QString("%1 of %2 and %3: %4, %5")
                                                                                         .arg(metricId(metric).data())
                                                                                         .arg(a)
                                                                                         .arg(b)
                                                                                         .arg(error)
                                                                                         .arg(expected)));
      }
    }
  }

  /// Of two constants the mean over both hemispheres is that of powers of cosines: <cos^n> = 1 / (n + 1).
  void closedFormsOfConstants() {
    const double a = 0.25, b = 0.16, d = a - b;
    const TabulatedBrdf reference = constantTable(a), test = constantTable(b);
    const std::vector<double> errors = brdfErrors(reference, test, halfPi, 2);
    const auto verify = [&](BrdfMetric metric, double expected, double tolerance) {
      QVERIFY2(
          std::abs(errors[std::size_t(metric)] / expected - 1) < tolerance,
          qPrintable(QString("%1 %2 %3").arg(metricId(metric).data()).arg(errors[std::size_t(metric)]).arg(expected)));
    };
    for (const BrdfMetric metric : {BrdfMetric::rms, BrdfMetric::projectedRms, BrdfMetric::meanAbsolute})
      verify(metric, d, 1e-6);
    // What is left is the grid's staircase at the horizon.
    verify(BrdfMetric::cosineL2, d / std::sqrt(3.0), 0.01);
    verify(BrdfMetric::cubeRoot, (std::cbrt(a) - std::cbrt(b)) * std::sqrt(3.0 / 5), 0.01);
    verify(BrdfMetric::gamma, (0.5 - 0.4) / std::sqrt(2.0), 0.01);
    verify(BrdfMetric::cosineCubeRoot, std::cbrt(d) * std::sqrt(3.0 / 5), 0.01);
    verify(BrdfMetric::cosinesCubeRoot, std::pow(d, 2.0 / 3) * 9 / 25, 0.01);
    verify(BrdfMetric::lab, greyLightness(pi * a) - greyLightness(pi * b), 1e-4);
  }

  /// Both materials 8 times as bright.
  void scalingLaws() {
    const HalfDifferenceGrid grid{30, 20, 24, true};
    const auto reference = bakeTable(*test::ggx(Rgb(0.3, 0.1, 0), Rgb(1), 0.2, 0.3), grid);
    const auto test = bakeTable(*test::ggx(Rgb(0.25, 0.2, 0.1), Rgb(0.8), 0.25, 0.3), grid);
    const std::vector<double> once = brdfErrors(*reference, *test, defaultMaxPolarAngle, 1.5);
    const std::vector<double> eight = brdfErrors(scaled(*reference, 8), scaled(*test, 8), defaultMaxPolarAngle, 1.5);
    const auto verify = [&](BrdfMetric metric, double factor) {
      const auto m = std::size_t(metric);
      QVERIFY2(std::abs(eight[m] / (factor * once[m]) - 1) < 1e-6, metricId(metric).data());
    };
    for (const BrdfMetric metric :
         {BrdfMetric::cosineL2, BrdfMetric::rms, BrdfMetric::projectedRms, BrdfMetric::meanAbsolute})
      verify(metric, 8);
    for (const BrdfMetric metric : {BrdfMetric::cubeRoot, BrdfMetric::cosineCubeRoot}) verify(metric, 2);
    for (const BrdfMetric metric : {BrdfMetric::gamma, BrdfMetric::cosinesCubeRoot}) verify(metric, 4);
    // Logarithms grow less than what they are taken of.
    for (const BrdfMetric metric : {BrdfMetric::log, BrdfMetric::meanAbsoluteLog, BrdfMetric::bieronPeersLog}) {
      const auto m = std::size_t(metric);
      QVERIFY(eight[m] > once[m] && eight[m] < 8 * once[m]);
    }
  }

  /// The gamma metric is the cosine-weighted L2 at 1 and the cube root at 3.
  void gammaMeetsItsNeighbours() {
    const auto table = bakeTable(*test::ggx(Rgb(0.3, 0.1, 0), Rgb(1), 0.2, 0.3), {30, 20, 24, true});
    const auto test = test::ggx(Rgb(0.25, 0.2, 0.1), Rgb(0.8), 0.25, 0.3);
    const auto gammaError = [&](double gamma) {
      return brdfError(BrdfMetric::gamma, *table, *test, defaultMaxPolarAngle, gamma);
    };
    QVERIFY(std::abs(gammaError(1) / brdfError(BrdfMetric::cosineL2, *table, *test) - 1) < 1e-12);
    QVERIFY(std::abs(gammaError(3) / brdfError(BrdfMetric::cubeRoot, *table, *test) - 1) < 1e-9);
    QVERIFY(std::abs(gammaError(2) / gammaError(2 + 1e-9) - 1) < 1e-6);
  }

  void equalValuesGiveZero() {
    const auto brdf = test::ggx(Rgb(0.3), Rgb(1), 0.01, 0.9);
    const auto table = bakeTable(*brdf);
    for (const double error : brdfErrors(*table, *table)) QCOMPARE(error, 0.0);
    // The model in double against its table in float.
    QVERIFY(brdfError(BrdfMetric::log, *table, *brdf) < 1e-6);
    QCOMPARE(brdfSignalToNoiseRatio(*table, *table), std::numeric_limits<double>::infinity());
  }

  /// Invalid cells of either side hold 0: counted, they would show.
  void invalidCellsOfEitherSideAreLeftOut() {
    const TabulatedBrdf whole = constantTable(0.25);
    Values values(whole.values().begin(), whole.values().end());
    Flags valid(whole.valid().begin(), whole.valid().end());
    for (std::size_t i = 0; i < valid.size(); i += 3) valid[i] = 0;
    const TabulatedBrdf holes(whole.grid(), values, valid);
    for (const double error : brdfErrors(whole, holes)) QCOMPARE(error, 0.0);
    for (const double error : brdfErrors(holes, whole)) QCOMPARE(error, 0.0);
    const TabulatedBrdf nothing(whole.grid(), values, Flags(valid.size(), 0));
    for (const double error : brdfErrors(nothing, whole)) QCOMPARE(error, 0.0);
  }

  void tablesOfOtherGridsAreInterpolated() {
    const TabulatedBrdf reference = constantTable(0.25), coarse = constantTable(0.25, {30, 45, 60, true});
    for (const double error : brdfErrors(reference, coarse)) QVERIFY(error < 1e-12);
  }

  /// A tenth of the value is 20 dB, whatever the cosines.
  /// Whatever a material is made of, it differs from itself by nothing.
  void anyFormEqualsItself_data() {
    QTest::addColumn<std::shared_ptr<const Brdf>>("brdf");
    for (const char* id : {"rgl/satin_purple", "rgl/chm_mint", "merl-copy/chrome", "sgd/brass"})
      QTest::newRow(id) << materials::readMaterial(std::string("library:") + id).brdf;
    for (const char* id : {"ward", "ggx", "lambert"}) {
      const models::Model& model = models::findModel(id);
      models::ParameterValues parameters = models::defaultParameters(model.spec());
      if (const auto width = model.spec().find("roughness-x")) parameters.values[*width] *= 3;
      QTest::newRow(id) << std::shared_ptr<const Brdf>(model.instantiate(parameters));
    }
    std::vector<glm::vec3> values;
    for (std::size_t i = 0; i < UtiaBrdf::directionCount * UtiaBrdf::directionCount; ++i)
      values.emplace_back(0.1f * float(i % 7), 0.2f * float(i % 3), 0.5f);
    QTest::newRow("utia") << std::shared_ptr<const Brdf>(std::make_shared<UtiaBrdf>(values));
    QTest::newRow("whole circle") << std::shared_ptr<const Brdf>(
        std::make_shared<TabulatedBrdf>(constantTable(0.2, {9, 9, 36, false})));
  }
  void anyFormEqualsItself() {
    QFETCH(std::shared_ptr<const Brdf>, brdf);
    for (const double error : brdfErrors(*brdf, *brdf)) QCOMPARE(error, 0.0);
    QVERIFY(std::isinf(brdfSignalToNoiseRatio(*brdf, *brdf)));
  }

  /// Light and viewer exchanged: a table that holds the mean of both orders is wrong by the other half at each.
  void bothOrdersCount() {
    const TabulatedBrdf mean = constantTable(0.3, {9, 9, 18});
    const test::FunctionBrdf oneSided(
        [](const Direction& wi, const Direction& wo) {
          return Rgb(wi.z > wo.z ? 0.4 : wi.z < wo.z ? 0.2 : 0.3);
        },
        true, false);
    // 0.1 but where both angles are equal, which they are at some of the table's nodes and nowhere else.
    const double error = brdfError(BrdfMetric::meanAbsolute, mean, oneSided);
    QVERIFY(error > 0.08 && error < 0.1);
    QVERIFY(std::abs(brdfError(BrdfMetric::meanAbsolute, oneSided, mean) - 0.1) < 1e-6);
  }

  /// A table is exact at its nodes alone: compared with what it was sampled from, it has an error; compared with a
  /// measured table of the same grid, it has that of the nodes.
  void tablesAreComparedBetweenTheirNodes() {
    const auto lobe = test::ggx(Rgb(0.2), Rgb(0.5), 0.2, 0.04);
    const auto table = bakeTable(*lobe, {.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 60});
    const double snr = brdfSignalToNoiseRatio(*lobe, *table);
    QVERIFY2(snr > 25 && snr < 60, qPrintable(QString::number(snr)));
    QVERIFY(brdfSignalToNoiseRatio(*table, *lobe) > 100);
    QVERIFY(brdfSignalToNoiseRatio(*lobe, *bakeTable(*lobe)) > snr + 10);
  }

  /// A separate loop over the directions that the header names, and random ones with their weights.
  void nativeFormsAreComparedAtTheStatedDirections_data() {
    QTest::addColumn<bool>("anisotropic");
    QTest::newRow("not reciprocal") << false;
    QTest::newRow("anisotropic") << true;
  }
  void nativeFormsAreComparedAtTheStatedDirections() {
    QFETCH(bool, anisotropic);
    const auto lobe = [&](const Direction& wi, const Direction& wo) {
      const Direction h = glm::normalize(wi + wo);
      const double grain = anisotropic ? 1 + h.x * h.x / (h.x * h.x + h.y * h.y + 1e-9) : 1;
      return Rgb(0.1, 0.2, 0.3) + Rgb(grain * std::pow(h.z, 20) * (1 + 0.5 * wi.z - 0.2 * wo.x * wi.x));
    };
    const test::FunctionBrdf reference(lobe, !anisotropic, false);
    const test::FunctionBrdf fit([](const Direction& wi, const Direction& wo) {
      return Rgb(0.2) + Rgb(1.2 * std::pow(glm::normalize(wi + wo).z, 15));
    });
    const HalfDifferenceGrid grid{.phiDCount = 180, .reciprocal = false};
    const GridDirections directions(grid, GridPoints::scattered);
    const double minCosine = std::cos(defaultMaxPolarAngle);
    double signal = 0, noise = 0, sum = 0, weights = 0;
    std::vector<double> measures, squares;
    for (std::size_t node = 0; node < grid.size(); ++node) {
      auto [pair, aboveHorizon] = directions.at(node);
      if (!aboveHorizon) continue;
      if (anisotropic) {
        const double turns = double(node) / ((1 + std::sqrt(5.0)) / 2);
        pair = AzimuthRotation(2 * pi * (turns - std::floor(turns)))(pair);
      }
      const Rgb r = reference.evaluate(pair.wi, pair.wo), t = fit.evaluate(pair.wi, pair.wo);
      const double cosines = std::max(0.0, pair.wi.z) * std::max(0.0, pair.wo.z);
      signal += cosines * cosines * glm::dot(r, r);
      noise += cosines * cosines * glm::dot(r - t, r - t);
      if (pair.wi.z < minCosine || pair.wo.z < minCosine) continue;
      measures.push_back(grid.cellMeasure(node));
      squares.push_back(glm::dot(r - t, r - t) / 3);
      sum += measures.back() * squares.back();
      weights += measures.back();
    }
    const double rms = std::sqrt(sum / weights);
    QVERIFY(std::abs(brdfSignalToNoiseRatio(reference, fit) - 10 * std::log10(signal / noise)) < 0.01);
    const double error = brdfError(BrdfMetric::rms, reference, fit);
    QVERIFY2(std::abs(error - rms) < 1e-6 * rms, qPrintable(QString("%1 %2").arg(error).arg(rms)));
    // Cells that are drawn by their weights have this mean.
    std::mt19937_64 random(3);
    std::discrete_distribution<std::size_t> draw(measures.begin(), measures.end());
    double mean = 0, square = 0;
    constexpr int count = 100'000;
    for (int i = 0; i < count; ++i) {
      const double value = squares[draw(random)];
      mean += value / count;
      square += value * value / count;
    }
    const double standardError = std::sqrt((square - mean * mean) / count);
    QVERIFY2(std::abs(mean - error * error) < 3 * standardError,
             qPrintable(QString("%1 %2 +- %3").arg(mean).arg(error * error).arg(standardError)));
  }

  void brdfSnrOfScaledValues() {
    const auto table = bakeTable(*test::ggx(Rgb(0.3), Rgb(1), 0.3, 0.3));
    Values values(table->values().begin(), table->values().end());
    for (auto& value : values) value *= 0.9f;
    const TabulatedBrdf test(table->grid(), values, Flags(table->valid().begin(), table->valid().end()));
    QVERIFY(std::abs(brdfSignalToNoiseRatio(*table, test) - 20) < 1e-5);
  }

  void sameBitsForAnyThreadCount() {
    const auto table = bakeTable(*test::ggx(Rgb(0.3), Rgb(1), 0.2, 0.3));
    const auto test = test::ggx(Rgb(0.2), Rgb(1), 0.1, 0.3);
    const auto run = [&](int threads) {
      const ThreadLimit limit(threads);
      std::vector<double> all = brdfErrors(*table, *test);
      all.push_back(brdfSignalToNoiseRatio(*table, *test));
      return all;
    };
    QVERIFY(run(1) == run(2));
  }

  void hardCase16DynamicRange() {
    // A relative change of 1e-6 gives d = 1e-6 x / (1 + x) of log(1 + x) at every magnitude: no digits lost.
    const HalfDifferenceGrid mirror{1, 1, 1, true};  // one node: theta_h = theta_d = 0, both cosines 1
    for (double x = 1e-9; x <= 1e6; x *= 10) {
      const TabulatedBrdf reference(mirror, Values(1, TabulatedBrdf::Value(float(x))), Flags(1, 1));
      const double value = reference.values()[0].x;
      const auto test = test::FunctionBrdf([&](const Direction&, const Direction&) { return Rgb(value * (1 + 1e-6)); });
      const double expected = std::log1p(1e-6 * value / (1 + value));
      QVERIFY(std::abs(brdfError(BrdfMetric::log, reference, test) / expected - 1) < 1e-9);
    }
  }

  void hardCase43NegativeReconstruction() {
    const TabulatedBrdf reference = constantTable(0.25, {10, 10, 10, true});
    const test::FunctionBrdf negative([](const Direction&, const Direction&) { return Rgb(-3); });
    const test::FunctionBrdf black([](const Direction&, const Direction&) { return Rgb(0); });
    QVERIFY(brdfErrors(reference, negative) == brdfErrors(reference, black));
    for (const double error : brdfErrors(reference, negative)) QVERIFY(std::isfinite(error) && error > 0);
  }

  void hardCase44ZeroReferenceOrZeroNoise() {
    const HalfDifferenceGrid grid{10, 10, 10, true};
    const TabulatedBrdf black = constantTable(0, grid), grey = constantTable(1, grid);
    QVERIFY(std::isnan(brdfSignalToNoiseRatio(black, black)));
    QVERIFY(std::isnan(brdfSignalToNoiseRatio(black, grey)));
    QVERIFY(std::abs(brdfSignalToNoiseRatio(grey, black)) < 1e-12);
  }

  void names() {
    for (const BrdfMetric metric : allBrdfMetrics()) {
      const MetricRecord& record = metricRecord(metric);
      QVERIFY(record.metric == metric);
      QVERIFY(metricByName(record.id) == metric);
      if (!record.alias.empty()) QVERIFY(metricByName(record.alias) == metric);
      QVERIFY(!record.name.empty() && !record.formula.empty() && !record.reference.empty());
      QCOMPARE(std::ranges::find(minimisableMetrics(), metric) != minimisableMetrics().end(), record.minimisable);
    }
    QVERIFY_THROWS_EXCEPTION(Error, metricByName("vibes"));
  }
};

GONIO_TEST(BrdfMetricsTest)
}  // namespace brdf_metrics_test

#include "brdf_metrics_test.moc"
