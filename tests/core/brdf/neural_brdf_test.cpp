// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/neural_brdf.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <vector>

#include "core/support/error.h"
#include "tests/support/test_program.h"

namespace neural_brdf_test {
using namespace gonio;

constexpr std::size_t hidden = NeuralBrdf::hidden;
constexpr std::size_t secondLayer = 7 * hidden, thirdLayer = secondLayer + hidden * (hidden + 1);

/// Output c is exp(scale times the input) - 1: one unit a layer that passes the input on, and a bias.
std::vector<float> passing(std::size_t input, float scale, float bias) {
  std::vector<float> weights(NeuralBrdf::weightCount, 0);
  weights[input * hidden] = 1;
  weights[secondLayer] = 1;
  for (std::size_t c = 0; c < 3; ++c) {
    weights[thirdLayer + c] = scale;
    weights[thirdLayer + 3 * hidden + c] = bias;
  }
  return weights;
}

std::string errorOf(const std::vector<float>& weights) {
  try {
    NeuralBrdf{weights};
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

class NeuralBrdfTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void biasesAloneAreAConstant() {
    const NeuralBrdf brdf(passing(0, 0, float(std::log(1.25))));
    const Rgb value = brdf.evaluate(fromSpherical(0.3, 1), fromSpherical(1.2, 2));
    for (int c = 0; c < 3; ++c) QVERIFY(std::abs(value[c] - 0.25) < 1e-6);
  }

  /// Inputs: sin and cos of theta_h at 0 and 2; sin theta_d cos phi_d, sin theta_d sin phi_d, cos theta_d at 3, 4, 5.
  void inputsAreTheHalfAndTheDifferenceVector() {
    const double thetaH = 0.4, thetaD = 0.7, phiD = 0.9;
    const DirectionPair pair = [&] {
      const Direction d{std::sin(thetaD) * std::cos(phiD), std::sin(thetaD) * std::sin(phiD), std::cos(thetaD)};
      const auto turned = [&](const Direction& w) {
        return Direction{w.x * std::cos(thetaH) + w.z * std::sin(thetaH), w.y,
                         -w.x * std::sin(thetaH) + w.z * std::cos(thetaH)};
      };
      return DirectionPair{turned(d), turned({-d.x, -d.y, d.z})};
    }();
    const double expected[] = {
        std::sin(thetaH), 0, std::cos(thetaH), std::sin(thetaD) * std::cos(phiD), std::sin(thetaD) * std::sin(phiD),
        std::cos(thetaD)};
    for (std::size_t input = 0; input < NeuralBrdf::inputs; ++input) {
      const NeuralBrdf brdf(passing(input, 2, 0));
      const double value = brdf.evaluate(pair.wi, pair.wo).x;
      QVERIFY2(std::abs(value - std::expm1(2 * expected[input])) < 1e-5, qPrintable(QString::number(input)));
      QVERIFY(std::abs(brdf.evaluate(pair.wo, pair.wi).x - value) < 1e-6);  // folded: reciprocal
    }
  }

  void valuesAreFiniteAndNotNegative() {
    const Direction up = fromSpherical(0.3, 1), grazing = fromSpherical(halfPi - 1e-9, 2), below{0.6, 0, -0.8};
    QVERIFY(NeuralBrdf(passing(5, 0, -3)).evaluate(up, grazing) == Rgb(0));
    const NeuralBrdf huge(passing(5, 1e6f, 0));
    for (const Direction& w : {up, grazing, Direction{0, 0, 1}})
      QVERIFY(std::isfinite(huge.evaluate(up, w).x) && huge.evaluate(up, w).x > 1e30);
    QVERIFY(huge.evaluate(up, below) == Rgb(0));
  }

  void weightsAreChecked() {
    std::vector<float> weights = passing(0, 1, 0);
    weights.back() = std::numeric_limits<float>::infinity();
    QVERIFY(errorOf(weights).find("weight 674") != std::string::npos);
    weights.pop_back();
    QVERIFY(errorOf(weights).find("674 weights, expected 675") != std::string::npos);
  }
};

GONIO_TEST(NeuralBrdfTest)
}  // namespace neural_brdf_test

#include "neural_brdf_test.moc"
