// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QTest>
#include <cmath>
#include <random>

#include "tests/support/function_brdf.h"
#include "tests/support/random_directions.h"
#include "tests/support/sampling_check.h"

/// What is asked of the importance sampling of every baseline.
namespace gonio::test {

/// Samples have the density that is stated; with those that are lost it integrates to 1. @param theta of wo, degrees.
inline void verifyDensity(const Brdf& brdf, double theta) {
  const auto check = checkSampling(brdf, fromSpherical(radians(theta), 0.7), 1 << 17, 1e-4);
  QVERIFY(check.valid);
  QVERIFY2(std::abs(check.integral + check.lost - 1) < 6e-3,
           qPrintable(QString("%1 %2").arg(check.integral).arg(check.lost)));
  QVERIFY2(check.pValue > 1e-4, qPrintable(QString::number(check.pValue)));
}

/// Wherever the BRDF is positive directions are sampled, and estimates of the albedo agree with a quadrature of
/// cosine-weighted samples, with at most `noise` times their noise.
inline void verifyEstimates(const Brdf& brdf, double noise) {
  const Direction wo = fromSpherical(radians(40), 1.1);
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> uniform;
  const auto moments = [&](const auto& draw) {
    double sum = 0, squares = 0;
    constexpr int count = 200'000;
    for (int i = 0; i < count; ++i) {
      const glm::dvec3 u(uniform(generator), uniform(generator), uniform(generator));
      const DirectionSample s = draw(u);
      const double value = s.pdf > 0 ? brdf.evaluate(s.wi, wo).y * s.wi.z / s.pdf : 0;
      sum += value / count;
      squares += value * value / count;
    }
    return std::pair(sum, std::sqrt(squares - sum * sum));
  };
  const auto own = moments([&](const glm::dvec3& u) { return brdf.sample(wo, u); });
  const auto cosine = moments([&](const glm::dvec3& u) { return test::lambert(Rgb(1)).sample(wo, u); });
  QVERIFY2(std::abs(own.first / cosine.first - 1) < 0.02,
           qPrintable(QString("%1 %2").arg(own.first).arg(cosine.first)));
  QVERIFY2(own.second < noise * cosine.second, qPrintable(QString("%1 %2").arg(own.second).arg(cosine.second)));
  for (int i = 0; i < 2000; ++i) {
    const Direction wi = test::randomUpper(generator);
    if (maxChannel(brdf.evaluate(wi, wo)) > 0) QVERIFY(brdf.pdf(wi, wo) > 0);
  }
}

}  // namespace gonio::test
