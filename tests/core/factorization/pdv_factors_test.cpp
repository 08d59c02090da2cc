// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_factors.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/coordinates/projected_deviation.h"
#include "core/factorization/deviation_grid.h"
#include "core/formats/pdv.h"
#include "core/math/parallel.h"
#include "core/metrics/brdf_metrics.h"
#include "core/models/registry.h"
#include "core/support/error.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace pdv_factors_test {
using namespace gonio;
using namespace gonio::factorization;
using test::randomUpper;

const HalfDifferenceGrid smallGrid{.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 60};

std::shared_ptr<const TabulatedBrdf> glossyTable() {
  models::ParameterValues values = models::defaultParameters(models::ggx().spec());
  values.values[models::ggx().spec().find("roughness").value()] = Rgb(0.2);
  return bakeTable(*models::ggx().instantiate(values), smallGrid);
}

/// Three terms with curves of every kind.
PdvFactors someFactors() {
  PdvFactors f{
      .thetaNodes = {0, 0.4, 1, 1.5}, .deviationNodes = {0, 0.1, 0.5, 2}, .phiNodes = {0, 1, pi}, .highest = 30};
  for (int channel = 0; channel < 3; ++channel)
    for (int term = 0; term < 3; ++term) {
      const double s = channel + 1, t = term + 1;
      f.channels[std::size_t(channel)].push_back(
          {{s, 0.5 * s, 2 * t, 1}, {1, 0.6 / t, 0.2, 0.1}, {1, term == 0 ? 1 : -0.5, 0.3}});
    }
  return f;
}

class PdvFactorsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// At the nodes the value is the inverse transform of the sum of the products.
  void evaluationWrittenOut() {
    PdvFactors f = someFactors();
    for (const DataTransform transform :
         {DataTransform::logPlus, DataTransform::cosineLog, DataTransform::none, DataTransform::gamma3}) {
      f.transform = transform;
      const auto brdf = makePdvBrdf(f);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          for (std::size_t k = 0; k < 3; ++k) {
            const auto at = fromProjectedDeviation({f.thetaNodes[i], f.deviationNodes[j], f.phiNodes[k]});
            if (!at.valid || (j == 0 && k > 0)) continue;
            for (int channel = 0; channel < 3; ++channel) {
              double y = 0;
              for (const PdvTerm& term : f.channels[std::size_t(channel)]) y += term.f1[i] * term.f2[j] * term.f3[k];
              const double weight = cosineWeight(at.pair.wi.z, at.pair.wo.z);
              const double expected = inverseTransformed(transform, y, weight);
              QVERIFY(std::abs(brdf->evaluate(at.pair.wi, at.pair.wo)[channel] - expected) <
                      1e-5 * std::max(1.0, expected));
            }
          }
    }
  }

  /// Below 0 the transforms are continued as odd functions, down to the lower bound of y.
  void negativeValuesWrittenOut() {
    PdvFactors f = someFactors();
    f.lowest = -0.5;
    for (PdvTerm& term : f.channels[0]) term.f1 = {-0.2, -0.3, -1, 2};
    const double ys[] = {-0.2 * 3, -0.3 * 3, -1 * 3};
    for (const DataTransform transform :
         {DataTransform::logPlus, DataTransform::cosineLog, DataTransform::root, DataTransform::none,
          DataTransform::logPlusTenth, DataTransform::gamma15, DataTransform::gamma3}) {
      f.transform = transform;
      const auto brdf = makePdvBrdf(f);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto at = fromProjectedDeviation({f.thetaNodes[i], 0, 0});
        const double weight = cosineWeight(at.pair.wi.z, at.pair.wo.z);
        const double expected = -inverseTransformed(transform, std::min(0.5, -ys[i]), weight);
        const double found = brdf->evaluate(at.pair.wi, at.pair.wo).x;
        QVERIFY2(std::abs(found - expected) < 1e-5 * std::max(1.0, -expected), QByteArray::number(found));
      }
    }
  }

  /// An edited curve of 1e300: values reach the bound of the factors, and samples have finite densities.
  void hardCase56HugeCurve() {
    PdvFactors f = someFactors();
    f.highest = 3;
    for (auto& channel : f.channels) channel[0].f1[1] = 1e300;
    const auto brdf = makePdvBrdf(f);
    const auto at = fromProjectedDeviation({0.4, 0, 0});
    QVERIFY(std::abs(brdf->evaluate(at.pair.wi, at.pair.wo).x / std::expm1(3.0) - 1) < 1e-6);
    for (const double theta : {0.0, 0.2, 0.39, 0.41, 0.9, 1.4})
      for (const double u : {0.05, 0.4, 0.95}) {
        const Direction wo = fromSpherical(theta, 0.3);
        const DirectionSample drawn = brdf->sample(wo, {u, u, 1 - u});
        const Rgb value = brdf->evaluate(drawn.wi, wo);
        QVERIFY(std::isfinite(drawn.pdf) && drawn.pdf > 0);
        for (int channel = 0; channel < 3; ++channel)
          QVERIFY(value[channel] >= 0 && value[channel] <= std::expm1(3.0) * (1 + 1e-6));
      }
  }

  void belowTheHorizonItIsZero() {
    const auto brdf = makePdvBrdf(someFactors());
    QCOMPARE(brdf->evaluate(fromSpherical(2, 0), {0, 0, 1}), Rgb(0));
    QCOMPARE(brdf->evaluate({0, 0, 1}, fromSpherical(2, 0)), Rgb(0));
  }

  /// With the viewer along the normal the azimuth of the light does not matter, but for F3.
  void hardCase06IsotropicForTheVerticalViewer() {
    PdvFactors f = someFactors();
    f.form = PdvForm::twoFactors;
    f.phiNodes = {0};
    for (auto& channel : f.channels)
      for (PdvTerm& term : channel) term.f3 = {1};
    const auto brdf = makePdvBrdf(f);
    const Rgb first = brdf->evaluate(fromSpherical(0.6, 0), {0, 0, 1});
    for (double phi = -3; phi < 3; phi += 0.5)
      QVERIFY(glm::length(brdf->evaluate(fromSpherical(0.6, phi), {0, 0, 1}) - first) < 1e-12);
  }

  /// Factors declare that light and viewer are no equals, and their values differ in the two orders.
  void hardCase48NotReciprocal() {
    const auto brdf = makePdvBrdf(someFactors());
    QVERIFY(!brdf->isReciprocal());
    const Direction wi = fromSpherical(0.3, 0.4), wo = fromSpherical(1, 2);
    QVERIFY(glm::length(brdf->evaluate(wi, wo) - brdf->evaluate(wo, wi)) > 1e-3 * glm::length(brdf->evaluate(wi, wo)));
  }

  void residualsFallWithTheTerms() {
    const PdvFactorization f = factorizePdv(*glossyTable(), {.terms = 8});
    QCOMPARE(f.residuals.size(), std::size_t(9));
    QCOMPARE(f.residuals[0], 1.0);
    for (std::size_t l = 1; l < f.residuals.size(); ++l) QVERIFY(f.residuals[l] <= f.residuals[l - 1]);
    QVERIFY2(f.residuals[8] < 0.05, QByteArray::number(f.residuals[8]));
    for (const auto& channel : f.factors.channels) {
      QCOMPARE(channel.size(), std::size_t(8));
      for (const auto* curve : {&channel[0].f1, &channel[0].f2, &channel[0].f3})
        for (const double value : *curve) QVERIFY(value >= 0);
    }
  }

  /// The residual is what the model misses at the nodes, weighted as it is documented.
  void theResidualIsThatOfTheModel() {
    const auto table = glossyTable();
    for (const PdvWeights weights : {PdvWeights::equal, PdvWeights::projectedSolidAngle}) {
      const PdvFactorization f = factorizePdv(*table, {.terms = 3, .weights = weights});
      const auto brdf = makePdvBrdf(f.factors);
      const std::vector<double>&thetas = f.factors.thetaNodes, &deviations = f.factors.deviationNodes;
      const double step = thetas[1] / 2;
      std::size_t cells = 0;
      double left = 0, total = 0;
      for (const double theta : thetas)
        for (std::size_t j = 0; j < deviations.size(); ++j)
          for (const double phi : f.factors.phiNodes) {
            const auto at = fromProjectedDeviation({theta, deviations[j], phi});
            if (!at.valid || at.pair.wi.z < std::cos(maxPolarAngle)) continue;
            bool valid = false;
            const Rgb rho = table->lookup(toHalfDifference(at.pair.wi, at.pair.wo), TableLookup::trilinear, &valid);
            if (!valid) continue;
            double weight = 1;
            if (weights == PdvWeights::projectedSolidAngle) {
              const double low = std::max(0.0, theta - step), high = std::min(thetas.back(), theta + step);
              const double inner = j > 0 ? (deviations[j - 1] + deviations[j]) / 2 : 0;
              const double outer = j + 1 < deviations.size() ? (deviations[j] + deviations[j + 1]) / 2 : deviations[j];
              weight = (phi == 0 || phi == pi ? 0.5 : 1) * (outer * outer - inner * inner) *
                       (std::pow(std::sin(high), 2) - std::pow(std::sin(low), 2)) * at.pair.wi.z * at.pair.wo.z *
                       std::pow(1 + rho.x, 0.25);
            }
            const double y = std::log1p(rho.x), model = std::log1p(brdf->evaluate(at.pair.wi, at.pair.wo).x);
            ++cells;
            total += weight * y * y;
            left += weight * (y - model) * (y - model);
          }
      // Nodes on the horizon's limit may fall on either side of it. The BRDF cuts at 0, on the mirror direction it
      // knows one phi only, and cells beside the disk count a little: nearly the same.
      QVERIFY(std::abs(double(cells) - double(f.cells)) < 200);
      QVERIFY2(std::abs(std::sqrt(left / total) - f.residuals[3]) < 0.05 * f.residuals[3],
               QByteArray::number(std::sqrt(left / total)) + " " + QByteArray::number(f.residuals[3]));
    }
  }

  /// A material that is separable in these coordinates is met by one term, at the largest deviations too, where no cell
  /// is.
  void separableMaterialsAreExact() {
    class Separable final : public Brdf {
     public:
      using Brdf::evaluate;
      void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
        for (std::size_t i = 0; i < pairs.size(); ++i) {
          const double dp = toProjectedDeviation(pairs[i].wi, pairs[i].wo).deviation;
          values[i] = Rgb(std::expm1(1 / (1 + 4 * dp * dp)), std::expm1(0.5 * std::exp(-dp)), 0);
        }
      }
    };
    const auto table = bakeTable(Separable());
    for (const PdvOptions& options :
         {PdvOptions{.form = PdvForm::twoFactors, .terms = 1}, {.terms = 1}, compactPdvOptions({.terms = 1})}) {
      const PdvFactorization f = factorizePdv(*table, options);
      QCOMPARE(f.factors.thetaNodes.size(), std::size_t(options.thetaNodes));
      QVERIFY2(f.residuals[1] < 2e-3, QByteArray::number(f.residuals[1]));
      const auto brdf = makePdvBrdf(f.factors);
      std::mt19937_64 random(1);
      for (int n = 0; n < 1000; ++n) {
        const Direction wi = randomUpper(random), wo = randomUpper(random);
        if (wi.z < 0.1 || wo.z < 0.1) continue;
        const Rgb difference = brdf->evaluate(wi, wo) - Separable().Brdf::evaluate(wi, wo);
        QVERIFY2(glm::length(difference) < 0.02, QByteArray::number(glm::length(difference)));
      }
    }
  }

  /// Colours outside sRGB: a channel that is negative everywhere, and one that is so beside the highlight. The first
  /// term stays positive, as its importance sampling needs.
  void negativeValuesOfTheTableAreKept() {
    class OutsideOfSrgb final : public Brdf {
     public:
      using Brdf::evaluate;
      void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
        for (std::size_t i = 0; i < pairs.size(); ++i) {
          const double dp = toProjectedDeviation(pairs[i].wi, pairs[i].wo).deviation, y = 1 / (1 + 4 * dp * dp);
          values[i] = {-std::expm1(0.3 * y), std::expm1(y), std::copysign(std::expm1(std::abs(y - 0.4)), y - 0.4)};
        }
      }
    };
    const OutsideOfSrgb truth;
    const auto table = bakeTable(truth, {45, 45, 120, false}, {}, 16, NegativeValues::stay);
    for (const bool joint : {false, true}) {
      const PdvFactorization f = factorizePdv(*table, {.terms = 3, .joint = joint});
      for (std::size_t l = 1; l < f.residuals.size(); ++l) QVERIFY(f.residuals[l] <= f.residuals[l - 1]);
      // Blue at |Dp| = 2, and the mirror direction of green.
      QVERIFY(std::abs(f.factors.lowest - (1.0 / 17 - 0.4)) < 1e-2 && std::abs(f.factors.highest - 1) < 1e-2);
      for (const auto& channel : f.factors.channels)
        for (const auto* curve : {&channel[0].f1, &channel[0].f2, &channel[0].f3})
          for (const double value : *curve) QVERIFY(value >= 0);
      const auto brdf = makePdvBrdf(f.factors);
      std::mt19937_64 random(1);
      for (int n = 0; n < 1000; ++n) {
        const Direction wi = randomUpper(random), wo = randomUpper(random);
        if (wi.z < 0.1 || wo.z < 0.1) continue;
        const double error = glm::length(brdf->evaluate(wi, wo) - truth.Brdf::evaluate(wi, wo));
        QVERIFY2(error < 0.02, QByteArray::number(error));
      }
    }
    // The first term of the wholly negative channel is 0.
    const PdvFactorization one = factorizePdv(*table, {.terms = 1});
    QVERIFY(std::ranges::all_of(one.factors.channels[0][0].f1, [](double value) { return value == 0; }));
  }

  void hardCase14ConstantNeedsOneTerm() {
    const TabulatedBrdf table(smallGrid, std::vector<glm::vec3>(smallGrid.size(), glm::vec3(0.5f)),
                              std::vector<std::uint8_t>(smallGrid.size(), 1));
    const PdvFactorization f = factorizePdv(table, {.terms = 1});
    QVERIFY2(f.residuals[1] < 1e-5, QByteArray::number(f.residuals[1]));
    QVERIFY(std::abs(f.factors.highest - std::log1p(0.5)) < 1e-5);
    const Rgb value = makePdvBrdf(f.factors)->evaluate(fromSpherical(0.5, 1), fromSpherical(0.9, 0));
    QVERIFY(std::abs(value.x - 0.5) < 1e-5);
  }

  void hardCase12BlackStaysBlack() {
    const TabulatedBrdf black(smallGrid, std::vector<glm::vec3>(smallGrid.size(), glm::vec3(0)),
                              std::vector<std::uint8_t>(smallGrid.size(), 1));
    const PdvFactorization f = factorizePdv(black, {.terms = 2});
    QVERIFY(f.residuals == std::vector<double>({0, 0, 0}));
    QCOMPARE(makePdvBrdf(f.factors)->evaluate(fromSpherical(0.5, 1), fromSpherical(0.9, 0)), Rgb(0));
  }

  void hardCase15SpikeStaysFinite() {
    std::vector<glm::vec3> values(smallGrid.size(), glm::vec3(0));
    values[smallGrid.index(3, 10, 7)] = glm::vec3(1e6);
    const TabulatedBrdf table(smallGrid, values, std::vector<std::uint8_t>(smallGrid.size(), 1));
    const PdvFactorization f = factorizePdv(table, {.terms = 5});
    std::mt19937_64 random(2);
    const auto brdf = makePdvBrdf(f.factors);
    for (int n = 0; n < 2000; ++n) {
      const Rgb value = brdf->evaluate(randomUpper(random), randomUpper(random));
      QVERIFY(std::isfinite(value.x) && value.x >= 0 && value.x <= 1e6 * (1 + 1e-5));
    }
  }

  void truncationKeepsTheFirstTerms() {
    const PdvFactors f = someFactors(), one = f.truncated(1);
    QCOMPARE(one.terms(), 1);
    QVERIFY(one.channels[2][0] == f.channels[2][0]);
    QVERIFY(f.truncated(7) == f);
  }

  /// A mirror takes nearly all nodes of |Dp|, but leaves no gap that curves cannot bridge.
  void noGapBetweenDeviationNodesIsWide() {
    std::vector<glm::vec3> values(smallGrid.size(), glm::vec3(0));
    for (int d = 0; d < smallGrid.thetaDCount; ++d)
      for (int p = 0; p < smallGrid.phiDCount; ++p) values[smallGrid.index(0, d, p)] = glm::vec3(1e4);
    const std::vector<std::uint8_t> valid(smallGrid.size(), 1);
    const std::shared_ptr<const TabulatedBrdf> tables[] = {std::make_shared<TabulatedBrdf>(smallGrid, values, valid)};
    const std::vector<double> nodes = deviationNodes(tables);
    for (std::size_t j = 1; j < nodes.size(); ++j) QVERIFY(nodes[j] - nodes[j - 1] < 3 * maxDeviation / 89 + 1e-9);
  }

  /// Compact curves halve the bytes of a term; twice as many terms in these bytes are more accurate.
  void compactCurvesBuyTerms() {
    const auto table = glossyTable();
    const PdvFactorization full = factorizePdv(*table, {.terms = 2, .joint = true});
    const PdvFactorization compact = factorizePdv(*table, compactPdvOptions({.terms = 4, .joint = true}));
    QVERIFY(formats::pdvFileBytes(compact.factors) < formats::pdvFileBytes(full.factors));
    const auto error = [&](const PdvFactors& factors) {
      return metrics::brdfError(metrics::BrdfMetric::logRelative, *table, *makePdvBrdf(factors));
    };
    QVERIFY2(error(compact.factors) < 0.8 * error(full.factors),
             QByteArray::number(error(compact.factors) / error(full.factors)));
  }

  void wrongOptionsAreErrors() {
    const auto table = glossyTable();
    QVERIFY_EXCEPTION_THROWN(factorizePdv(*table, {.terms = 0}), Error);
    QVERIFY_EXCEPTION_THROWN(factorizePdv(*table, {.terms = 21}), Error);
    QVERIFY_EXCEPTION_THROWN(factorizePdv(*table, {.deviationNodes = {0, 1, 1}}), Error);
    QVERIFY_EXCEPTION_THROWN(factorizePdv(*table, {.deviationNodes = {0.1, 1}}), Error);
    QVERIFY_EXCEPTION_THROWN(factorizePdv(*table, {.thetaNodes = 1}), Error);
    QVERIFY_EXCEPTION_THROWN(factorizePdv(*table, {.phiNodes = maxPdvNodes + 1}), Error);
  }

  void hardCase50SameBitsForAnyNumberOfThreads() {
    const auto table = glossyTable();
    const PdvFactorization all = factorizePdv(*table, {.terms = 2});
    const ThreadLimit one(1);
    QVERIFY(factorizePdv(*table, {.terms = 2}).factors == all.factors);
  }

  void deviationNodesAreQuantiles() {
    // Energy 1 in the first quarter and 3 beyond: a tenth of it all is spent there.
    std::vector<double> energy(2000, 3.0);
    std::fill(energy.begin(), energy.begin() + 500, 1.0);
    const std::vector<double> nodes = deviationNodes(energy, 11);
    QCOMPARE(nodes.front(), 0.0);
    QCOMPARE(nodes.back(), maxDeviation);
    QVERIFY(std::abs(nodes[1] - maxDeviation / 4) < 1e-9);
    QVERIFY(std::abs(nodes[10] - nodes[9] - maxDeviation / 12) < 1e-9);
    for (const auto& flat : {std::vector<double>(2000, 0.0), std::vector<double>(2000, 1.0)})
      QVERIFY(std::abs(deviationNodes(flat, 11)[5] - maxDeviation / 2) < 1e-9);
    std::vector<double> spike(2000, 0.0);
    spike[0] = 1;
    const std::vector<double> close = deviationNodes(spike, 90);
    for (std::size_t i = 1; i < close.size(); ++i) QVERIFY(close[i] > close[i - 1]);
    QCOMPARE(close.back(), maxDeviation);
  }
};

GONIO_TEST(PdvFactorsTest)
}  // namespace pdv_factors_test

#include "pdv_factors_test.moc"
