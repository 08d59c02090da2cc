// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/gaussian_process.h"

#include <Eigen/LU>
#include <QTest>
#include <cmath>

#include "core/metrics/brdf_metrics.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace gaussian_process_test {
using namespace gonio;
using namespace gonio::baselines;
using namespace gonio::factorization;

const HalfDifferenceGrid grid{.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 60};

HalfDifferenceSamples samplesOf(const Brdf& brdf, const HalfDifferenceAxes& axes) {
  return sampleHalfDifference(*bakeTable(brdf, grid), axes);
}

class GaussianProcessTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void sizes() {
    QCOMPARE(gaussianNodes(0), 1);
    QCOMPARE(gaussianNodes(24 * 101), 100);
    QCOMPARE(gaussianNodes(1'000'000'000), maxGaussianNodes);
    const auto fit = fitGaussianProcess(samplesOf(test::lambert(Rgb(0.5)), gaussianAxes()), 7);
    QCOMPARE(fit.bytes(), std::size_t(24 * 8));
  }

  /// With a node at each of a few samples, the process is the exact one: K (K + noise)^-1 y, by its definition.
  void fewSamplesAreThoseOfTheExactProcess() {
    const auto brdf = test::ggx(Rgb(0.3, 0.1, 0.05), Rgb(1), 0.4, 0.05);
    const HalfDifferenceSamples samples = samplesOf(*brdf, makeHalfDifferenceAxes(5, 4, 3));
    const GaussianProcess fit = fitGaussianProcess(samples, 60);
    std::vector<Eigen::Vector3d> points;
    std::vector<double> values;
    for (std::size_t h = 0; h < 5; ++h)
      for (std::size_t d = 0; d < 4; ++d)
        for (std::size_t p = 0; p < 3; ++p)
          if (const std::size_t i = samples.axes.index(h, d, p); samples.valid[i]) {
            points.push_back(gaussianPoint({samples.axes.thetaH[h], samples.axes.thetaD[d], samples.axes.phiD[p]}));
            values.push_back(std::log(1 + samples.values[i].x));
          }
    const auto n = Eigen::Index(points.size());
    const auto kernel = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      const double r = std::sqrt(3.0) * (a - b).cwiseQuotient(fit.lengths.cast<double>()).norm();
      return (1 + r) * std::exp(-r);
    };
    Eigen::MatrixXd k(n, n);
    Eigen::VectorXd y(n);
    double mean = 0;
    for (const double value : values) mean += value / double(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      y[i] = values[std::size_t(i)] - mean;
      for (Eigen::Index j = 0; j < n; ++j)
        k(i, j) = kernel(points[std::size_t(i)], points[std::size_t(j)]) + (i == j ? 1e-4 : 0);
    }
    const Eigen::VectorXd weights = k.fullPivLu().solve(y);
    const auto process = makeGaussianProcessBrdf(fit);
    std::mt19937_64 random(5);
    for (int i = 0; i < 200; ++i) {
      const Direction wi = test::randomUpper(random), wo = test::randomUpper(random);
      const Eigen::Vector3d at = gaussianPoint(toHalfDifference(wi, wo));
      double expected = mean;
      for (Eigen::Index j = 0; j < n; ++j) expected += weights[j] * kernel(at, points[std::size_t(j)]);
      const double found = process->evaluate(wi, wo).x;
      QVERIFY2(std::abs(found - std::max(0.0, std::expm1(expected))) < 2e-3 * (1 + found),
               qPrintable(QString("%1 %2").arg(found).arg(expected)));
    }
  }

  void constantIsExact() {
    const auto process =
        makeGaussianProcessBrdf(fitGaussianProcess(samplesOf(test::lambert(Rgb(0.2, 0.5, 0.8)), gaussianAxes()), 5));
    const Rgb value = process->evaluate(fromSpherical(0.4, 0), fromSpherical(1.1, 2));
    for (int c = 0; c < 3; ++c) QVERIFY(std::abs(value[c] - Rgb(0.2, 0.5, 0.8)[c] / pi) < 1e-5);
  }

  void symmetries() {
    const auto brdf = test::ggx(Rgb(0.3, 0.1, 0.05), Rgb(1), 0.2, 0.05);
    const auto process = makeGaussianProcessBrdf(fitGaussianProcess(samplesOf(*brdf, gaussianAxes()), 100));
    std::mt19937_64 random(6);
    for (int i = 0; i < 100; ++i) {
      const Direction wi = test::randomUpper(random), wo = test::randomUpper(random);
      const double value = process->evaluate(wi, wo).x;
      QVERIFY(std::abs(process->evaluate(wo, wi).x - value) < 1e-4 * (1 + value));
      QVERIFY(std::abs(process->evaluate({wi.x, -wi.y, wi.z}, {wo.x, -wo.y, wo.z}).x - value) < 1e-4 * (1 + value));
    }
  }

  void stops() {
    std::stop_source stop;
    stop.request_stop();
    QVERIFY_THROWS_EXCEPTION(
        Cancelled, fitGaussianProcess(samplesOf(test::lambert(Rgb(0.5)), gaussianAxes()), 5, {stop.get_token(), {}}));
  }
};

GONIO_TEST(GaussianProcessTest)
}  // namespace gaussian_process_test

#include "gaussian_process_test.moc"
