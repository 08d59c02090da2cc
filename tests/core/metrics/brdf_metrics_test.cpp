// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/brdf_metrics.h"

#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/math/parallel.h"
#include "core/support/error.h"
#include "tests/support/function_brdf.h"

using namespace gonio;
using namespace gonio::metrics;

namespace {

using Values = std::vector<TabulatedBrdf::Value>;
using Flags = std::vector<std::uint8_t>;

/// Every cell above the horizon holds `value`.
TabulatedBrdf constantTable(double value, const HalfDifferenceGrid& grid = {}) {
  return *bakeTable(testing::FunctionBrdf([&](const Direction&, const Direction&) { return Rgb(value); }), grid);
}

/// The definition, cell by cell with the grid's own methods.
double plainError(BrdfMetric metric, const TabulatedBrdf& reference, const Brdf& test, double maxPolarAngle) {
  double sum = 0, weightSum = 0;
  for (std::size_t i = 0; i < reference.grid().size(); ++i) {
    if (!reference.valid()[i] || !reference.grid().nodeWithin(i, maxPolarAngle)) continue;
    const auto [wi, wo] = reference.grid().directions(i);
    const double weight = reference.grid().cellMeasure(i);
    const Rgb value = test.evaluate(wi, wo);
    for (int channel = 0; channel < 3; ++channel) {
      const double r = reference.values()[i][channel] * wi.z, t = value[channel] * wi.z;
      const double d = metric == BrdfMetric::cosineL2   ? r - t
                       : metric == BrdfMetric::cubeRoot ? std::cbrt(r) - std::cbrt(t)
                                                        : std::log(1 + r) - std::log(1 + t);
      sum += weight * (metric == BrdfMetric::meanAbsoluteLog ? std::abs(d) : d * d);
      weightSum += weight;
    }
  }
  return metric == BrdfMetric::meanAbsoluteLog ? sum / weightSum : std::sqrt(sum / weightSum);
}

}  // namespace

class BrdfMetricsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void agreesWithTheDefinition() {
    const HalfDifferenceGrid grid{36, 18, 36, true};  // has nodes at exactly 60, 80 and 85 degrees
    const auto table = bakeTable(*testing::ggx(Rgb(0.3, 0.1, 0), Rgb(1), 0.2, 0.3), grid);
    const auto test = testing::ggx(Rgb(0.25, 0.2, 0.1), Rgb(0.8), 0.25, 0.3);
    for (const double angle : {60.0, 80.0, 85.0}) {
      const std::vector<double> errors = brdfErrors(*table, *test, radians(angle));
      for (std::size_t m = 0; m < errors.size(); ++m) {
        const double expected = plainError(allBrdfMetrics()[m], *table, *test, radians(angle));
        QVERIFY2(std::abs(errors[m] / expected - 1) < 1e-9,
                 qPrintable(QString("%1: %2, %3").arg(int(m)).arg(errors[m]).arg(expected)));
        QCOMPARE(brdfError(allBrdfMetrics()[m], *table, *test, radians(angle)), errors[m]);
      }
    }
  }

  void equalValuesGiveZero() {
    const auto brdf = testing::ggx(Rgb(0.3), Rgb(1), 0.01, 0.9);
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
  void brdfSnrOfScaledValues() {
    const auto table = bakeTable(*testing::ggx(Rgb(0.3), Rgb(1), 0.3, 0.3));
    Values values(table->values().begin(), table->values().end());
    for (auto& value : values) value *= 0.9f;
    const TabulatedBrdf test(table->grid(), values, Flags(table->valid().begin(), table->valid().end()));
    QVERIFY(std::abs(brdfSignalToNoiseRatio(*table, test) - 20) < 1e-5);
  }

  void sameBitsForAnyThreadCount() {
    const auto table = bakeTable(*testing::ggx(Rgb(0.3), Rgb(1), 0.2, 0.3));
    const auto test = testing::ggx(Rgb(0.2), Rgb(1), 0.1, 0.3);
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
      const auto test =
          testing::FunctionBrdf([&](const Direction&, const Direction&) { return Rgb(value * (1 + 1e-6)); });
      const double expected = std::log1p(1e-6 * value / (1 + value));
      QVERIFY(std::abs(brdfError(BrdfMetric::log, reference, test) / expected - 1) < 1e-9);
    }
  }

  void hardCase43NegativeReconstruction() {
    const TabulatedBrdf reference = constantTable(0.25, {10, 10, 10, true});
    const testing::FunctionBrdf negative([](const Direction&, const Direction&) { return Rgb(-3); });
    const testing::FunctionBrdf black([](const Direction&, const Direction&) { return Rgb(0); });
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
    for (const BrdfMetric metric : allBrdfMetrics()) QVERIFY(metricByName(metricName(metric)) == metric);
    QVERIFY_THROWS_EXCEPTION(Error, metricByName("vibes"));
  }
};

QTEST_APPLESS_MAIN(BrdfMetricsTest)
#include "brdf_metrics_test.moc"
