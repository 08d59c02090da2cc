// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/measured_values.h"

#include <QTest>
#include <cmath>
#include <limits>

#include "core/support/error.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace measured_values_test {
using namespace gonio;
using namespace gonio::acquisition;

/// The same pair many times: statistics over its samples.
SamplingPlan repeated(const DirectionPair& pair, int count) {
  SamplingPlan plan;
  for (int i = 1; i <= count; ++i) plan.samples.push_back({i, pair, i});
  return plan;
}

struct Statistics {
  double mean = 0, deviation = 0;
};

Statistics of(const std::vector<Rgb>& values, int channel) {
  Statistics s;
  for (const Rgb& value : values) s.mean += value[channel] / double(values.size());
  for (const Rgb& value : values) s.deviation += std::pow(value[channel] - s.mean, 2) / double(values.size());
  s.deviation = std::sqrt(s.deviation);
  return s;
}

constexpr int many = 20000;
const DirectionPair pair{fromSpherical(0.4, 0.3), fromSpherical(0.9, 2.5)};

class MeasuredValuesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void withoutErrors() {
    const test::FunctionBrdf brdf([](const Direction& wi, const Direction& wo) { return Rgb(wi.x, wo.z, 2); });
    const MeasuredValues measured = measure(brdf, repeated(pair, 3));
    QVERIFY(measured.noise.empty());
    QVERIFY(measured.rgb == std::vector<Rgb>(3, Rgb(pair.wi.x, pair.wo.z, 2)));
  }

  void noiseHasTheDeviationItTells() {
    const auto brdf = test::lambert(Rgb(0.1, 1, 10));
    const MeasuredValues measured =
        measure(brdf, repeated(pair, many), {.relative = 0.1, .absolute = 0.01, .misalignment = 0, .seed = 3});
    QCOMPARE(measured.noise.size(), measured.rgb.size());
    for (int channel = 0; channel < 3; ++channel) {
      const double value = std::pow(10.0, channel - 1) / pi;
      const double expected = std::sqrt(0.01 * value * value + 1e-4);
      QVERIFY(std::abs(measured.noise[7][channel] / expected - 1) < 1e-12);
      const Statistics s = of(measured.rgb, channel);
      QVERIFY(std::abs(s.deviation / expected - 1) < 0.03);
      QVERIFY(std::abs(s.mean - value) < 4 * expected / std::sqrt(many));
    }
  }

  /// Arms point by Gaussian angles beside where they should, of both axes alike.
  void misalignment() {
    const double sigma = 0.02;
    const test::FunctionBrdf brdf([](const Direction& wi, const Direction& wo) {
      const auto aside = [](const Direction& w, const Direction& from) {
        return std::asin(std::min(1.0, glm::length(glm::cross(w, from))));
      };
      return Rgb(aside(wi, pair.wi), aside(wo, pair.wo), std::abs(glm::length(wi) - 1));
    });
    const MeasuredValues measured = measure(brdf, repeated(pair, many), {.misalignment = sigma});
    QVERIFY(measured.noise.empty());
    for (int channel = 0; channel < 2; ++channel) {
      double squares = 0;
      for (const Rgb& value : measured.rgb) squares += value[channel] * value[channel] / many;
      QVERIFY(std::abs(squares / (2 * sigma * sigma) - 1) < 0.03);
    }
    for (const Rgb& value : measured.rgb) QVERIFY(value.z < 1e-12);
  }

  /// Twice the errors are the same draws twice as large; another seed draws others; no reading is below 0.
  void seeds() {
    const auto brdf = test::lambert(Rgb(1));
    const SamplingPlan plan = repeated(pair, 50);
    const auto once = measure(brdf, plan, {.relative = 0.01}), twice = measure(brdf, plan, {.relative = 0.02});
    for (std::size_t i = 0; i < 50; ++i)
      QVERIFY(std::abs((twice.rgb[i].x - 1 / pi) - 2 * (once.rgb[i].x - 1 / pi)) < 1e-12);
    QVERIFY(measure(brdf, plan, {.relative = 0.01}).rgb == once.rgb);
    QVERIFY(measure(brdf, plan, {.relative = 0.01, .seed = 2}).rgb != once.rgb);
    int zeros = 0;
    for (const Rgb& value : measure(brdf, plan, {.absolute = 10}).rgb) {
      QVERIFY(value.x >= 0);
      zeros += value.x == 0;
    }
    QVERIFY(zeros > 10);
  }

  /// An arm that would go below the horizon stands on it.
  void horizon() {
    const test::FunctionBrdf brdf(
        [](const Direction& wi, const Direction& wo) { return Rgb(wi.z < 0, wo.z < 0, glm::length(wi)); });
    const DirectionPair grazing{fromSpherical(halfPi, 1), fromSpherical(halfPi, 3)};
    for (const Rgb& value : measure(brdf, repeated(grazing, 100), {.misalignment = 0.1}).rgb)
      QVERIFY(value.x == 0 && value.y == 0 && std::abs(value.z - 1) < 1e-12);
  }

  void refusals() {
    const auto brdf = test::lambert(Rgb(1));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY_EXCEPTION_THROWN(measure(brdf, repeated(pair, 1), {.relative = -1}), Error);
    QVERIFY_EXCEPTION_THROWN(measure(brdf, repeated(pair, 1), {.absolute = nan}), Error);
    QVERIFY_EXCEPTION_THROWN(measure(brdf, repeated(pair, 1), {.misalignment = INFINITY}), Error);
  }
};

GONIO_TEST(MeasuredValuesTest)
}  // namespace measured_values_test

#include "measured_values_test.moc"
