// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/linear_solve.h"

#include <QTest>
#include <random>

#include "tests/support/test_program.h"

namespace linear_solve_test {
using namespace gonio;
using namespace gonio::fitting;

LinearVector vectorOf(std::initializer_list<double> values) {
  LinearVector v(Eigen::Index(values.size()));
  std::copy(values.begin(), values.end(), v.data());
  return v;
}

/// A channel with two bases, a broad and a narrow one, and a measurement that is given.
struct Channel {
  std::vector<double> cosI, factor, rootWeight, broad, narrow, values, transformed, startWeight;

  ChannelProblem problem(metrics::BrdfMetric metric, double upper = 100) {
    const MetricTransform transform(metric);
    factor.clear();
    transformed.clear();
    startWeight.clear();
    for (std::size_t i = 0; i < values.size(); ++i) {
      factor.push_back(transform.factor(cosI[i], 0.5));
      transformed.push_back(transform.transform(values[i] * factor[i]));
      startWeight.push_back(rootWeight[i] * transform.slope(values[i] * factor[i]) * factor[i]);
    }
    return {.metric = transform,
            .factor = factor,
            .rootWeight = rootWeight,
            .transformed = transformed,
            .startWeight = startWeight,
            .values = values,
            .bases = {broad, narrow},
            .lower = vectorOf({0, 0}),
            .upper = vectorOf({upper, upper})};
  }
};

Channel makeChannel(double a, double b, double noise) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  Channel c;
  for (int i = 0; i < 400; ++i) {
    c.cosI.push_back(0.05 + 0.95 * uniform(random));
    c.rootWeight.push_back(std::sqrt(uniform(random) / 200));
    c.broad.push_back(0.3);
    c.narrow.push_back(1e4 * std::exp(-30 * uniform(random)));
    c.values.push_back((a * c.broad.back() + b * c.narrow.back()) * std::exp(noise * (uniform(random) - 0.5)));
  }
  return c;
}

double costAt(const ChannelProblem& p, double a, double b) {
  const std::vector<double> model = p.model(vectorOf({a, b}));
  double cost = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double d = p.metric.transform(model[i] * p.factor[i]) - p.transformed[i];
    const double r = p.rootWeight[i] * p.metric.shape(d);
    cost += r * r;
  }
  return cost;
}

class LinearSolveTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void exactDataAreRecovered_data() {
    QTest::addColumn<metrics::BrdfMetric>("metric");
    for (const metrics::BrdfMetric metric : metrics::minimisableMetrics())
      QTest::newRow(std::string(metrics::metricId(metric)).c_str()) << metric;
  }
  void exactDataAreRecovered() {
    QFETCH(metrics::BrdfMetric, metric);
    Channel channel = makeChannel(0.7, 0.02, 0);
    const ChannelSolution solution = solveLinearParameters(channel.problem(metric), {});
    QVERIFY(std::abs(solution.parameters[0] - 0.7) < 1e-6);
    QVERIFY(std::abs(solution.parameters[1] - 0.02) < 1e-7);
  }

  void noisyDataReachTheMinimum_data() { exactDataAreRecovered_data(); }
  /// Against brute force: no point around, near or far, is better.
  void noisyDataReachTheMinimum() {
    QFETCH(metrics::BrdfMetric, metric);
    Channel channel = makeChannel(0.7, 0.02, 1);
    const ChannelProblem problem = channel.problem(metric);
    const ChannelSolution solution = solveLinearParameters(problem, {});
    const double a = solution.parameters[0], b = solution.parameters[1];
    // Reweighting creeps along the edges of a sum of absolute values: good enough for a fit.
    const double tolerance = problem.metric.isReweighted() ? 1e-3 : 1e-9;
    QVERIFY(std::abs(solution.cost / costAt(problem, a, b) - 1) < 1e-12);
    for (const double da : {0.1, 0.5, 0.9, 0.99, 0.999, 1.0, 1.001, 1.01, 1.1, 2.0, 10.0})
      for (const double db : {0.1, 0.5, 0.9, 0.99, 0.999, 1.0, 1.001, 1.01, 1.1, 2.0, 10.0})
        QVERIFY(costAt(problem, a * da, b * db) >= solution.cost * (1 - tolerance));
  }

  void boundsHold() {
    Channel channel = makeChannel(0.7, 0.02, 0.5);
    const ChannelSolution capped = solveLinearParameters(channel.problem(metrics::BrdfMetric::log, 0.5), {});
    QCOMPARE(capped.parameters[0], 0.5);
    // What the broad basis explains best with a negative share stays without it.
    for (std::size_t i = 0; i < channel.values.size(); ++i) channel.values[i] = 0.02 * channel.narrow[i] * 0.9;
    for (double& value : channel.values) value = std::max(0.0, value - 0.1);
    QCOMPARE(solveLinearParameters(channel.problem(metrics::BrdfMetric::log), {}).parameters[0], 0.0);
  }

  void hardCase12BlackChannelIsExactlyZero() {
    Channel channel = makeChannel(0, 0, 0);
    for (const metrics::BrdfMetric metric : metrics::minimisableMetrics()) {
      const ChannelSolution solution = solveLinearParameters(channel.problem(metric), vectorOf({1, 1}));
      QCOMPARE(solution.parameters[0], 0.0);
      QCOMPARE(solution.parameters[1], 0.0);
      QCOMPARE(solution.cost, 0.0);
    }
  }
};

GONIO_TEST(LinearSolveTest)
}  // namespace linear_solve_test

#include "linear_solve_test.moc"
