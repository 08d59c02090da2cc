// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/sampling/directional_albedo.h"

#include <QTest>
#include <cmath>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace directional_albedo_test {
using namespace gonio;

class DirectionalAlbedoTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void hardCase12BlackTables() {
    const HalfDifferenceGrid grid{2, 2, 2, true};
    const std::vector<TabulatedBrdf::Value> black(grid.size(), TabulatedBrdf::Value(0));
    const std::vector<TabulatedBrdf::Value> red(grid.size(), TabulatedBrdf::Value(2, 0, 0));
    const std::vector<std::uint8_t> valid(grid.size(), 1), invalid(grid.size(), 0);
    QCOMPARE(directionalAlbedo(TabulatedBrdf(grid, black, valid), 0.5), Rgb(0));
    QCOMPARE(directionalAlbedo(TabulatedBrdf(grid, red, invalid), 0.5), Rgb(0));
  }

  void lambertReflectsItsAlbedo() {
    const Rgb albedo(0.2, 0.5, 0.9);
    for (const double angle : {0.0, 30.0, 60.0, 80.0, 89.0}) {
      const Rgb value = directionalAlbedo(test::lambert(albedo), radians(angle));
      QVERIFY(maxChannel(glm::abs(value - albedo)) < 1e-12);
    }
  }

  /// f = (n + 1) / (2 pi) cos^(n - 1) theta_i reflects exactly 1.
  void powersOfTheCosineReflectOne() {
    for (const double n : {2.0, 5.0, 20.0}) {
      const test::FunctionBrdf brdf(
          [n](const Direction& wi, const Direction&) { return Rgb((n + 1) / (2 * pi) * std::pow(wi.z, n - 1)); });
      for (const double angle : {0.0, 0.8})
        QVERIFY2(std::abs(directionalAlbedo(brdf, angle).x - 1) < 1e-3,
                 qPrintable(QString("%1 %2 %3").arg(n).arg(angle).arg(directionalAlbedo(brdf, angle).x)));
    }
  }

  /// Published figures (rounded to three digits) of a lossless GGX with separable masking, roughness 0.2.
  void whiteFurnaceOfGgx() {
    const auto brdf = test::ggx(Rgb(0), Rgb(1), 0.2, 1);
    const std::pair<double, double> figures[] = {{0, 0.948}, {45, 0.924}, {75, 0.851}, {89, 0.901}};
    for (const auto& [angle, expected] : figures) {
      const double albedo = directionalAlbedo(*brdf, radians(angle)).x;
      QVERIFY2(std::abs(albedo - expected) < 1e-3, qPrintable(QString("%1 at %2 degrees").arg(albedo).arg(angle)));
    }
  }

  /// Of a table of a mirror: as the model, up to what the grid resolves.
  void albedoOfASharpTable() {
    const auto brdf = test::ggx(Rgb(0), Rgb(1), 0.02, 0.9);
    const auto table = bakeTable(*brdf);
    for (const double angle : {10.0, 45.0, 70.0})
      QVERIFY(std::abs(directionalAlbedo(*table, radians(angle)).x / directionalAlbedo(*brdf, radians(angle)).x - 1) <
              0.02);
  }
};

GONIO_TEST(DirectionalAlbedoTest)
}  // namespace directional_albedo_test

#include "directional_albedo_test.moc"
