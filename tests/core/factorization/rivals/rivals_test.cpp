// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/rivals/rivals.h"

#include <QTest>
#include <cmath>
#include <random>
#include <set>

#include "core/factorization/rivals/half_out_samples.h"
#include "core/metrics/brdf_metrics.h"
#include "tests/support/function_brdf.h"

using namespace gonio;
using namespace gonio::factorization;

namespace {

const HalfDifferenceGrid smallGrid{.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 60};

}  // namespace

class RivalsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Each keeps a glossy material better than the diffuse mean would, within its budget, without negative values.
  void rebuildAGlossyMaterial_data() {
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < rivals().size(); ++i) QTest::newRow(rivals()[i].id.data()) << int(i);
  }
  void rebuildAGlossyMaterial() {
    QFETCH(int, index);
    const Rival& rival = rivals()[std::size_t(index)];
    const auto table = bakeTable(*testing::ggx(Rgb(0.3, 0.1, 0.05), Rgb(1), 0.3, 0.05), smallGrid);
    const RivalModel model = rival.build(*table, 20'000, {});
    QVERIFY(model.bytes > 0 && model.bytes <= 20'000);
    QVERIFY(model.seconds >= 0);
    const double decibels = metrics::brdfSignalToNoiseRatio(*table, *model.brdf);
    QVERIFY2(decibels > 15, qPrintable(QString::number(decibels)));
    std::mt19937_64 generator(5);
    for (int i = 0; i < 3000; ++i) {
      const Rgb value = model.brdf->evaluate(testing::randomUpper(generator), testing::randomUpper(generator));
      for (int c = 0; c < 3; ++c) QVERIFY(std::isfinite(value[c]) && value[c] >= 0);
    }
    QCOMPARE(model.brdf->evaluate({0, 0, -1}, {0, 0, 1}), Rgb(0));
  }

  void hardCase12BlackTable() {
    const auto black = bakeTable(testing::lambert(Rgb(0)), smallGrid);
    for (const Rival& rival : rivals()) {
      const Rgb value = rival.build(*black, 5000, {}).brdf->evaluate({0, 0.6, 0.8}, {0.6, 0, 0.8});
      QVERIFY2(maxChannel(value) < 1e-4, rival.id.data());
    }
  }

  void named() {
    std::set<std::string_view> ids;
    for (const Rival& rival : rivals()) {
      ids.insert(rival.id);
      QVERIFY(!rival.name.empty() && !rival.reference.empty());
    }
    QCOMPARE(ids.size(), rivals().size());
  }

  /// Half-out samples are the table's values; the measure integrates to 1/2 for the viewer's polar angle times pi / 2
  /// for the half of the hemisphere that the azimuths cover.
  void halfOutSamplesOfALambertian() {
    const auto table = bakeTable(testing::lambert(Rgb(1)), smallGrid);
    const HalfOutSamples s = sampleHalfOut(*table, makeHalfOutAxes(90, 60, 45));
    double sum = 0;
    for (std::size_t h = 0; h < s.axes.thetaH.size(); ++h)
      for (std::size_t p = 0; p < s.axes.phiH.size(); ++p)
        for (std::size_t o = 0; o < s.axes.thetaO.size(); ++o) {
          const std::size_t i = s.axes.index(h, p, o);
          if (s.valid[i]) QVERIFY(std::abs(s.values[i].x - 1 / pi) < 1e-6);
          sum += projectedMeasure(s, h, p, o);
        }
    QVERIFY2(std::abs(sum / (pi / 4) - 1) < 0.02, qPrintable(QString::number(sum / (pi / 4))));
  }
};

QTEST_APPLESS_MAIN(RivalsTest)
#include "rivals_test.moc"
