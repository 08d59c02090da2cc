// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/render_material.h"

#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/models/registry.h"
#include "core/sampling/directional_albedo.h"
#include "tests/support/function_brdf.h"
#include "tests/support/leading_parameters.h"
#include "tests/support/test_program.h"

namespace reflection_bound_test {
using namespace gonio;
using namespace gonio::rendering;

ReflectionBound boundOf(std::shared_ptr<const Brdf> brdf) { return RenderMaterial(std::move(brdf)).bound(); }

double maxAlbedo(const Brdf& brdf) {
  double albedo = 0;
  for (const double theta : {0, 45, 70, 80, 85, 89})
    albedo = std::max(albedo, maxChannel(directionalAlbedo(brdf, radians(theta))));
  return albedo;
}

/// A(F) of one viewer by brute force: all cells of a grid of the hemisphere, the brightest first.
std::vector<double> bruteForce(const Brdf& brdf, double theta, const std::vector<double>& fractions) {
  constexpr int rings = 300, sectors = 300;  // a half: models are symmetric about the plane of the viewer
  std::vector<double> values;
  const Direction wo = fromSpherical(radians(theta), 0);
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < sectors; ++j) {
      const Direction wi = fromSpherical(std::asin(std::sqrt((i + 0.5) / rings)), pi * (j + 0.5) / sectors);
      values.push_back(maxChannel(brdf.evaluate(wi, wo)));
    }
  std::ranges::sort(values, std::greater());
  std::vector<double> result;
  for (const double fraction : fractions) {
    double sum = 0;
    for (std::size_t i = 0; i < std::size_t(fraction * double(values.size())); ++i) sum += values[i];
    result.push_back(pi * sum / double(values.size()));
  }
  return result;
}

class ReflectionBoundTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// A(F) = albedo F in the brightest channel: as stated, and from sampled directions.
  void lambertIsALine() {
    const Rgb reflectance(0.3, 0.7, 0.1);
    const ReflectionBound drawn = boundOf(models::findModel("lambert").instantiate({{reflectance}}));
    for (const ReflectionBound& bound : {diffuseMaterial(reflectance)->bound(), drawn}) {
      for (double fraction = 0; fraction <= 1; fraction += 1.0 / 256) {
        QVERIFY(bound.at(fraction) >= 0.7 * fraction * (1 - 1e-12));
        QVERIFY(bound.at(fraction) <= 0.7 * fraction * (1 + 1e-9));
      }
      QVERIFY(std::abs(bound.maxAlbedo() - 0.7) < 1e-9);
    }
  }

  /// All that a mirror reflects may come from a speck.
  void mirrorsRiseAtOnce() {
    const ReflectionBound bound = boundOf(test::ggx(Rgb(0), Rgb(1), 0.005, 0.9));
    QVERIFY(bound.maxAlbedo() > 0.85);
    QVERIFY(bound.at(1e-3) > 0.8 * bound.maxAlbedo());
    QVERIFY(bound.at(1e-4) > 0.5 * bound.maxAlbedo());
    QCOMPARE(bound.at(0), 0.0);
  }

  void itNeverFalls() {
    for (const models::Model* model : models::allModels()) {
      const ReflectionBound bound = boundOf(model->instantiate(models::defaultParameters(model->spec())));
      double last = 0;
      for (double place = 0; place <= 1; place += 1.0 / 1000) {
        const double value = bound.at(place * place);
        QVERIFY2(std::isfinite(value) && value >= last * (1 - 1e-12), model->spec().id.data());
        last = value;
      }
      QCOMPARE(bound.at(2), bound.at(1));
    }
  }

  void blackIsBlack() {
    QVERIFY(diffuseMaterial(Rgb(0))->bound().isBlack());
    QVERIFY(boundOf(test::ggx(Rgb(0), Rgb(0), 0.1, 1)).isBlack());
    QVERIFY(!diffuseMaterial({0, 0, 1e-6})->bound().isBlack());
  }

  /// The largest directional albedo of every model, by quadrature.
  void albedosOfModelsAgreeWithQuadrature() {
    for (const models::Model* model : models::allModels()) {
      const auto brdf = model->instantiate(models::defaultParameters(model->spec()));
      const double expected = maxAlbedo(*brdf);
      const double found = boundOf(model->instantiate(models::defaultParameters(model->spec()))).maxAlbedo();
      QVERIFY2(found > 0.93 * expected && found < 1.2 * expected,
               qPrintable(QString("%1: %2, expected %3").arg(model->spec().id.data()).arg(found).arg(expected)));
    }
  }

  /// Against all directions of a grid, at the viewer that is worst; and never much below.
  void sharesAgreeWithBruteForce() {
    for (const double roughness : {0.1, 0.3, 0.6}) {
      const auto brdf = test::ggx(Rgb(0.2), Rgb(1), roughness, 0.3);
      const ReflectionBound bound = boundOf(test::ggx(Rgb(0.2), Rgb(1), roughness, 0.3));
      const std::vector<double> fractions{0.001, 0.01, 0.1, 0.3, 1.0};
      std::vector<double> expected(fractions.size(), 0);
      for (const double theta : {0, 30, 60, 75, 80, 85, 89}) {
        const std::vector<double> one = bruteForce(*brdf, theta, fractions);
        for (std::size_t i = 0; i < fractions.size(); ++i) expected[i] = std::max(expected[i], one[i]);
      }
      for (std::size_t i = 0; i < fractions.size(); ++i) {
        const double found = bound.at(fractions[i]);
        QVERIFY2(
            found > 0.93 * expected[i] && found < 1.15 * expected[i] + 1.0 / 512,
            qPrintable(
                QString("%1 at %2: %3, expected %4").arg(roughness).arg(fractions[i]).arg(found).arg(expected[i])));
      }
    }
  }

  /// Ward-Dür gains energy at grazing angles: the bound says so.
  void wardDuerGains() {
    const models::Model& model = models::findModel("ward-duer");
    const auto brdf = model.instantiate(test::leadingParameters(model, {Rgb(0), Rgb(1), Rgb(0.4)}));
    QVERIFY(maxAlbedo(*brdf) > 1.2);
    QVERIFY(boundOf(model.instantiate(test::leadingParameters(model, {Rgb(0), Rgb(1), Rgb(0.4)}))).maxAlbedo() > 1.2);
  }

  /// A material that reflects along one azimuth alone is not taken for black or dim by the azimuth that is looked at.
  void anisotropicViewersAreAllLookedAt() {
    for (const double turn : {0.0, 90.0, 45.0}) {
      const auto reflects = [turn](const Direction& wi, const Direction& wo) {
        return Rgb(wi.z > 0 && std::abs(std::remainder(degrees(azimuth(wo)) - turn, 180)) < 22 ? 0.9 / pi : 0);
      };
      const ReflectionBound bound = boundOf(std::make_shared<const test::FunctionBrdf>(reflects, false));
      QVERIFY(std::abs(bound.maxAlbedo() - 0.9) < 0.1);
    }
  }
};

GONIO_TEST(ReflectionBoundTest)
}  // namespace reflection_bound_test

#include "reflection_bound_test.moc"
