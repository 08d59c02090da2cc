// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/shaders/reciprocal_lobes.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/export/shaders/shading_models.h"
#include "core/models/registry.h"
#include "tests/support/function_brdf.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace reciprocal_lobes_test {
using namespace gonio;
using exports::GgxAlpha;
using exports::ReciprocalLobes;

ReciprocalLobes known() {
  return {.diffuse = Rgb(0.3, 0.2, 0.1),
          .lobes = {{GgxAlpha(0.3), Rgb(0.06, 0.05, 0.04), Rgb(0.5), Rgb(1)},
                    {GgxAlpha(0.05), Rgb(0.04), Rgb(0.9, 0.8, 0.7), Rgb(1)}}};
}

void expectColour(const Rgb& found, const Rgb& expected, double tolerance) {
  for (int c = 0; c < 3; ++c)
    QVERIFY2(std::abs(found[c] - expected[c]) < tolerance,
             qPrintable(QString("%1, expected %2").arg(found[c]).arg(expected[c])));
}

class ReciprocalLobesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The layered model has the same lobes by code of its own.
  void lobesAreThoseOfTheLayeredModel() {
    const models::ModelSpec& spec = models::layered().spec();
    models::ParameterValues p = models::defaultParameters(spec);
    const auto set = [&](const char* id, const Rgb& value) { p.values[*spec.find(id)] = value; };
    const ReciprocalLobes lobes = known();
    set("diffuse", lobes.diffuse);
    set("flakes", Rgb(0));
    set("flakes-edge", Rgb(0));
    set("base", lobes.lobes[0].normal);
    set("base-edge", lobes.lobes[0].edge);
    set("base-roughness", Rgb(lobes.lobes[0].alpha.x));
    set("coat", lobes.lobes[1].normal);
    set("coat-edge", lobes.lobes[1].edge);
    set("coat-roughness", Rgb(lobes.lobes[1].alpha.x));
    const auto expected = models::layered().instantiate(p);
    const auto found = exports::reciprocalLobesBrdf(lobes);
    std::mt19937_64 random(3);
    for (int i = 0; i < 200; ++i) {
      const Direction wi = test::randomUpper(random), wo = test::randomUpper(random);
      const double wanted = expected->evaluate(wi, wo).x;
      QVERIFY(std::abs(found->evaluate(wi, wo).x - wanted) < 1e-9 * (1 + wanted));
    }
  }

  void aSumOfLobesIsFound() {
    const exports::PictureCells cells(true);
    const auto material = exports::reciprocalLobesBrdf(known());
    const ReciprocalLobes found = exports::fitReciprocalLobes(*material, cells, 2);
    QCOMPARE(found.lobes.size(), std::size_t(2));
    expectColour(found.diffuse, known().diffuse, 0.01);
    for (std::size_t j = 0; j < 2; ++j) {
      QVERIFY(std::abs(found.lobes[j].alpha.x / known().lobes[j].alpha.x - 1) < 0.05);
      expectColour(found.lobes[j].normal, known().lobes[j].normal, 0.01);
      expectColour(found.lobes[j].edge, known().lobes[j].edge, 0.1);
    }
  }

  void theGrainIsFound() {
    const exports::PictureCells cells(false);
    ReciprocalLobes grain = known();
    grain.lobes.resize(1);
    grain.lobes[0].alpha = GgxAlpha(0.4, 0.15);
    grain.rotation = 0.6;
    const ReciprocalLobes found = exports::fitReciprocalLobes(*exports::reciprocalLobesBrdf(grain), cells, 1);
    QCOMPARE(found.lobes.size(), std::size_t(1));
    const bool swapped = found.lobes[0].alpha.x < found.lobes[0].alpha.y;
    const auto [x, y] = found.lobes[0].alpha;
    QVERIFY(std::abs((swapped ? y : x) - 0.4) < 0.02 && std::abs((swapped ? x : y) - 0.15) < 0.01);
    QVERIFY(std::abs(std::sin(found.rotation + (swapped ? halfPi : 0) - 0.6)) < 0.02);
  }

  /// The colours of a formula with compensation, tint82 among them, are found by that formula.
  void refinementKnowsTheFormula() {
    const exports::PictureCells cells(true);
    ReciprocalLobes lobes = known();
    lobes.lobes.resize(1);
    lobes.lobes[0] = {GgxAlpha(0.6), Rgb(0.7, 0.5, 0.3), Rgb(0.8), Rgb(0.5)};
    ReciprocalLobes start = lobes;
    start.lobes[0].normal = start.lobes[0].edge = Rgb(0.5);
    start.lobes[0].tint82 = Rgb(0.9);
    const auto material = exports::schlickLobesBrdf(lobes);
    const ReciprocalLobes found = exports::refineLobes(*material, cells, start, exports::schlickLobesBrdf);
    expectColour(found.lobes[0].normal, lobes.lobes[0].normal, 0.02);
    expectColour(found.lobes[0].tint82, lobes.lobes[0].tint82, 0.1);
  }

  /// A matte material has no highlight, and nothing goes wrong.
  void aMatteMaterialIsLambert() {
    const exports::PictureCells cells(true);
    const ReciprocalLobes found = exports::fitReciprocalLobes(test::lambert(Rgb(0.5, 0.3, 0.1)), cells, 3);
    expectColour(found.diffuse, Rgb(0.5, 0.3, 0.1), 0.01);
    const ReciprocalLobes black = exports::fitReciprocalLobes(test::lambert(Rgb(0)), cells, 3);
    expectColour(black.diffuse, Rgb(0), 1e-9);
    const exports::PictureCells grainCells(false);
    expectColour(exports::fitReciprocalLobes(test::lambert(Rgb(0)), grainCells, 1).diffuse, Rgb(0), 1e-9);
  }

  void aStopEndsTheFit() {
    std::stop_source stop;
    stop.request_stop();
    const exports::PictureCells cells(true);
    const auto material = exports::reciprocalLobesBrdf(known());
    QVERIFY_THROWS_EXCEPTION(Cancelled, exports::fitReciprocalLobes(*material, cells, 2, {stop.get_token(), {}}));
  }
};

GONIO_TEST(ReciprocalLobesTest)
}  // namespace reciprocal_lobes_test

#include "reciprocal_lobes_test.moc"
