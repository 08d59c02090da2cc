// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/alternatives/separated_components.h"

#include <QTest>
#include <cmath>

#include "core/metrics/brdf_metrics.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace separated_components_test {
using namespace gonio;
using namespace gonio::dictionary;

constexpr HalfDifferenceGrid grid{.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 36};
using Table = std::shared_ptr<const TabulatedBrdf>;

Table plastic(const Rgb& diffuse, double roughness) {
  return bakeTable(*test::ggx(diffuse, Rgb(1), roughness, 0.05), grid);
}
double error(const TabulatedBrdf& a, const TabulatedBrdf& b) {
  return metrics::brdfError(metrics::BrdfMetric::log, a, b);
}

class SeparatedComponentsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void partsAreNotNegativeAndAddUp() {
    const Table table = plastic(Rgb(0.3, 0.1, 0.02), 0.2);
    const SeparatedTable parts = separateDiffuse(*table);
    QVERIFY(std::ranges::equal(parts.diffuse->valid(), table->valid()));
    QVERIFY(std::ranges::equal(parts.specular->valid(), table->valid()));
    for (std::size_t cell = 0; cell < grid.size(); ++cell)
      for (int c = 0; c < 3; ++c) {
        const float diffuse = parts.diffuse->values()[cell][c], specular = parts.specular->values()[cell][c];
        QVERIFY(diffuse >= 0 && specular >= 0);
        QVERIFY(std::abs(diffuse + specular - table->values()[cell][c]) <= 1e-6f * table->values()[cell][c]);
      }
  }

  void matteMaterialIsDiffuse() {
    const Table table = bakeTable(test::lambert(Rgb(0.8, 0.4, 0)), grid);
    const SeparatedTable parts = separateDiffuse(*table);
    QVERIFY(std::ranges::equal(parts.diffuse->values(), table->values()));
    for (const TabulatedBrdf::Value& value : parts.specular->values()) QVERIFY(value == TabulatedBrdf::Value(0));
  }

  /// The diffuse part of a sum of Lambert's and a narrow highlight is Lambert's.
  void plasticIsItsTwoTerms() {
    const Rgb albedo(0.3, 0.1, 0.02);
    const SeparatedTable parts = separateDiffuse(*plastic(albedo, 0.1));
    const Table highlight = plastic(Rgb(0), 0.1);
    double worst = 0;
    for (std::size_t cell = 0; cell < grid.size(); ++cell)
      if (grid.nodeAboveHorizon(cell) && grid.nodeWithin(cell, radians(70)))
        for (int c = 0; c < 3; ++c)
          worst = std::max({worst, std::abs(parts.diffuse->values()[cell][c] - albedo[c] / pi),
                            std::abs(double(parts.specular->values()[cell][c]) - highlight->values()[cell][c])});
    QVERIFY2(worst < 0.005, qPrintable(QString::number(worst)));
  }

  /// All components hold the training materials; those of other colours need the diffuse components alone.
  void codesOfTrainingMaterials() {
    const std::vector<Table> tables{plastic(Rgb(0.3, 0.1, 0.02), 0.1), plastic(Rgb(0.05), 0.3),
                                    plastic(Rgb(0.5, 0.6, 0.7), 0.5), plastic(Rgb(0.01, 0.2, 0.4), 0.05)};
    const SeparatedComponents basis = learnSeparatedComponents(tables.size(), [&](std::size_t m) { return tables[m]; });
    QVERIFY(basis.count() >= basis.specular.count() + 1);
    QCOMPARE(basis.specularCount(basis.count()), basis.specular.count());
    std::vector<double> errors;
    for (const int components : {1, 4, basis.count()}) {
      const SeparatedCode code = encode(basis, *tables[0], components);
      QCOMPARE(code.diffuse.components() + code.specular.components(), components);
      QCOMPARE(code.halfBytes(), 2 * std::size_t(3 * sizeof(float)) + 3 * std::size_t(components) * 2);
      errors.push_back(error(*tables[0], *decode(basis, code)));
    }
    QVERIFY2(errors[1] < errors[0] && errors[2] <= errors[1] * 1.001,
             qPrintable(QString("%1 %2 %3").arg(errors[0]).arg(errors[1]).arg(errors[2])));
    QVERIFY2(errors[2] < 0.01, qPrintable(QString::number(errors[2])));
  }

  void refusals() {
    const Table table = plastic(Rgb(0.3), 0.3);
    const SeparatedComponents basis = learnSeparatedComponents(1, [&](std::size_t) { return table; });
    QVERIFY_THROWS_EXCEPTION(Error, encode(basis, *bakeTable(test::lambert(Rgb(1)), {6, 6, 6}), 1));
    std::stop_source stop;
    stop.request_stop();
    QVERIFY_THROWS_EXCEPTION(Cancelled, separateDiffuse(*table, {stop.get_token(), {}}));
  }
};

GONIO_TEST(SeparatedComponentsTest)
}  // namespace separated_components_test

#include "separated_components_test.moc"
