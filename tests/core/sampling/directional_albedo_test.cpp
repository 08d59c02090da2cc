// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/sampling/directional_albedo.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "tests/support/function_brdf.h"
#include "tests/support/spiky_table.h"
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

  /// Tables of 1e-4 with 1e6 in one cell, which is narrower than the spacing of the pattern.
  void hardCase53SpikeOfOneCell_data() {
    QTest::addColumn<int>("thetaH");
    QTest::addColumn<int>("thetaD");
    QTest::addColumn<int>("phiD");
    QTest::addColumn<double>("viewer");
    QTest::newRow("at the normal, all azimuths") << 0 << 0 << -1 << 0.0;
    QTest::newRow("at the normal, between the nodes") << 0 << 0 << -1 << 0.4;
    QTest::newRow("mirror pairs at 20 degrees") << 0 << 20 << -1 << 20.0;
    QTest::newRow("mirror pairs at 70 degrees, one azimuth") << 0 << 70 << 90 << 70.2;
    QTest::newRow("one cell off the highlight") << 40 << 30 << 45 << 44.2;
    QTest::newRow("retroreflection") << 40 << 0 << -1 << 17.8;
  }
  void hardCase53SpikeOfOneCell() {
    QFETCH(int, thetaH);
    QFETCH(int, thetaD);
    QFETCH(int, phiD);
    QFETCH(double, viewer);
    const auto table = test::spikyTable(thetaH, thetaD, phiD, phiD < 0 ? 1e6f : 1e8f);
    const double expected = test::albedoOfSpike(*table, radians(viewer), std::max(0, thetaH - 1), thetaH + 1);
    const double found = directionalAlbedo(*table, radians(viewer)).x;
    QVERIFY2(expected > 1e-3, qPrintable(QString::number(expected)));
    QVERIFY2(std::abs(found / expected - 1) < 0.02, qPrintable(QString("%1, expected %2").arg(found).arg(expected)));
  }

  /// In closed form: for a viewer at the normal, the interpolation in sqrt theta_h leaves a tenth of the disk's square.
  void hardCase53SpikeAtTheNormalInClosedForm() {
    const double radius = halfPi / (90.0 * 90.0), expected = 1e6 * 8 * pi * radius * radius / 10 + 1e-4 * pi;
    const double found = directionalAlbedo(*test::spikyTable(0, 0, -1, 1e6f), 0).x;
    QVERIFY2(std::abs(found / expected - 1) < 0.01, qPrintable(QString("%1, expected %2").arg(found).arg(expected)));
  }

  /// Without peaks the bounds change no bit of the result.
  void boundsChangeNothingWithoutPeaks() {
    const auto table =
        bakeTable(*test::ggx(Rgb(0.2), Rgb(0.5), 0.2, 0.5), {.thetaHCount = 30, .thetaDCount = 20, .phiDCount = 36});
    const test::FunctionBrdf unbounded(
        [&](const Direction& wi, const Direction& wo) { return table->evaluate(wi, wo); });
    for (const double theta : {0.0, 0.7, 1.3})
      QCOMPARE(directionalAlbedo(*table, theta), directionalAlbedo(unbounded, theta));
  }
};

GONIO_TEST(DirectionalAlbedoTest)
}  // namespace directional_albedo_test

#include "directional_albedo_test.moc"
