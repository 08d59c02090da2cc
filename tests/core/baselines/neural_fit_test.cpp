// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/neural_fit.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/math/parallel.h"
#include "core/metrics/brdf_metrics.h"
#include "core/support/error.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace neural_fit_test {
using namespace gonio;
using namespace gonio::baselines;

Weights randomWeights(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  return Weights::NullaryExpr([&] { return uniform(random); });
}

/// Pairs of directions, their samples, and values of `material`.
struct Data {
  std::vector<DirectionPair> pairs;
  std::vector<Rgb> values;
  Batch batch;
};
Data dataOf(const Brdf& material, std::mt19937_64& random, Eigen::Index count) {
  Data data;
  data.batch.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const DirectionPair pair{test::randomUpper(random), test::randomUpper(random)};
    const Rgb value = material.evaluate(pair.wi, pair.wo);
    const auto inputs = NeuralBrdf::inputsAt(toHalfDifference(pair.wi, pair.wo));
    for (int k = 0; k < inputCount; ++k) data.batch.inputs(k, i) = inputs[std::size_t(k)];
    for (int c = 0; c < outputCount; ++c) data.batch.targets(c, i) = std::log1p(value[c] * pair.wi.z);
    data.batch.cosines[i] = pair.wi.z;
    data.pairs.push_back(pair);
    data.values.push_back(value);
  }
  return data;
}

NeuralFitOptions shortTraining(int steps) { return {.steps = steps, .samples = 1 << 15}; }

class NeuralFitTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Central differences of all weights. Rectifiers have kinks, which a step of 1e-6 rarely crosses.
  void gradientIsThatOfFiniteDifferences() {
    std::mt19937_64 random(3);
    const Weights weights = randomWeights(random);
    const Data data = dataOf(*test::ggx(Rgb(0.3, 0.1, 0.05), Rgb(1), 0.3, 0.05), random, 40);
    Loss loss;
    Weights gradient, unused;
    loss.evaluate(weights, data.batch, gradient);
    QVERIFY(gradient.norm() > 0.1);
    constexpr double step = 1e-6;
    for (int i = 0; i < weightCount; ++i) {
      Weights low = weights, high = weights;
      low[i] -= step;
      high[i] += step;
      const double slope =
          (loss.evaluate(high, data.batch, unused) - loss.evaluate(low, data.batch, unused)) / (2 * step);
      QVERIFY2(std::abs(slope - gradient[i]) < 1e-6 * gradient.norm(), qPrintable(QString::number(i)));
    }
  }

  /// The loss of weights is that of the values that NeuralBrdf evaluates. Biases of 1 make all values positive.
  void lossIsThatOfTheEvaluatedNetwork() {
    std::mt19937_64 random(4);
    Weights weights = 0.2 * randomWeights(random);
    weights.tail(outputCount).setOnes();
    const Data data = dataOf(test::lambert(Rgb(0.2, 0.5, 0.8)), random, 200);
    std::array<float, NeuralBrdf::weightCount> single;
    for (int i = 0; i < weightCount; ++i) single[std::size_t(i)] = float(weights[i]);
    const NeuralBrdf brdf(single);
    double sum = 0;
    for (std::size_t i = 0; i < data.pairs.size(); ++i) {
      const auto& [wi, wo] = data.pairs[i];
      const Rgb value = brdf.evaluate(wi, wo);
      for (int c = 0; c < 3; ++c) {
        QVERIFY(value[c] > 0);
        const double error = std::log(1 + value[c] * wi.z) - std::log(1 + data.values[i][c] * wi.z);
        sum += std::sqrt(error * error + Loss::smoothing * Loss::smoothing) - Loss::smoothing;
      }
    }
    Weights gradient;
    QVERIFY(std::abs(Loss().evaluate(weights, data.batch, gradient) / (sum / 600) - 1) < 1e-5);
  }

  /// Marks: within 2 dB of the SNR when they were set.
  void reproducesClosedForms() {
    const HalfDifferenceGrid grid{.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 60};
    const auto snr = [&](const Brdf& brdf) {
      const NeuralFit fit = fitNeural(brdf, shortTraining(4000));
      if (fit.losses.size() != 20 || !(fit.losses.back() < fit.losses.front()) || !(fit.seconds > 0)) return 0.0;
      return metrics::brdfSignalToNoiseRatio(*bakeTable(brdf, grid), NeuralBrdf(fit.weights));
    };
    const double matte = snr(test::lambert(Rgb(0.2, 0.5, 0.8)));
    QVERIFY2(matte > 60, qPrintable(QString::number(matte)));
    const double glossy = snr(*test::ggx(Rgb(0.3, 0.1, 0.05), Rgb(1), 0.3, 0.05));
    QVERIFY2(glossy > 26, qPrintable(QString::number(glossy)));
  }

  void deterministicForASeed() {
    const auto brdf = test::ggx(Rgb(0.1), Rgb(1), 0.2, 0.05);
    NeuralFitOptions options = shortTraining(50);
    const NeuralFit one = fitNeural(*brdf, options);
    {
      const ThreadLimit limit(1);
      QVERIFY(fitNeural(*brdf, options).weights == one.weights);
    }
    options.seed = 2;
    QVERIFY(fitNeural(*brdf, options).weights != one.weights);
  }

  /// Light and viewer exchanged: the network, which is reciprocal, learns a value between both.
  void learnsBothOrders() {
    const test::FunctionBrdf brdf([](const Direction& wi, const Direction& wo) { return Rgb(wi.z > wo.z ? 0.9 : 0.1); },
                                  true, false);
    const NeuralBrdf learned(fitNeural(brdf, shortTraining(300)).weights);
    const Direction wi = fromSpherical(0.3, 0), wo = fromSpherical(1, 2);
    const double value = learned.evaluate(wi, wo).x;
    QVERIFY(std::abs(learned.evaluate(wo, wi).x - value) < 1e-6);
    QVERIFY2(value > 0.05 && value < 0.95, qPrintable(QString::number(value)));
  }

  void blackMaterialIsBlack() {
    const NeuralBrdf black(fitNeural(test::lambert(Rgb(0)), shortTraining(1000)).weights);
    QVERIFY(maxChannel(black.evaluate(fromSpherical(0.3, 0), fromSpherical(1, 2))) < 1e-2);
  }

  void stopsAndRefuses() {
    std::stop_source stop;
    const TaskControl control{stop.get_token(), [&](double fraction) {
                                if (fraction > 0.3) stop.request_stop();
                              }};
    QVERIFY_THROWS_EXCEPTION(Cancelled, fitNeural(test::lambert(Rgb(0.5)), shortTraining(2000), control));
    QVERIFY_THROWS_EXCEPTION(Error, fitNeural(test::lambert(Rgb(0.5)), {.steps = 0}));
    const auto nothing = std::make_shared<const TabulatedBrdf>(
        HalfDifferenceGrid{2, 3, 4, true}, std::vector<glm::vec3>(24, glm::vec3(0)), std::vector<std::uint8_t>(24, 0));
    QVERIFY_THROWS_EXCEPTION(Error, fitNeural(*nothing, shortTraining(10)));
  }
};

GONIO_TEST(NeuralFitTest)
}  // namespace neural_fit_test

#include "neural_fit_test.moc"
