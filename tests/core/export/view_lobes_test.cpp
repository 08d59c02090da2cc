// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/shaders/view_lobes.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/export/shaders/shading_formulas.h"
#include "core/models/surface_geometry.h"
#include "core/sampling/directional_albedo.h"
#include "tests/support/function_brdf.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace view_lobes_test {
using namespace gonio;
using exports::ViewLobes;

/// A body and one lobe of a width that the fit tries, whose colour grows toward the horizon.
ViewLobes known() {
  ViewLobes lobes{.alphas = {std::pow(0.002, 6.0 / 17)}, .thetas = {0, radians(42.5), radians(85)}, .weights = {}};
  lobes.weights = {{Rgb(0.3, 0.2, 0.1), Rgb(0.3, 0.2, 0.1), Rgb(0.1)}, {Rgb(0.05), Rgb(0.1, 0.12, 0.14), Rgb(0.6)}};
  return lobes;
}

class ViewLobesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// A GGX lobe without Fresnel term is the model of Walter et al. with F = 1; in Blender 4 with the correlated
  /// masking.
  void aLobeIsTheGgxModel() {
    const auto model = test::ggx(Rgb(0.25), Rgb(0.5), 0.3, 1);
    const auto separable = exports::viewLobesBrdf({{0.3}, {0}, {{Rgb(0.25)}, {Rgb(0.5)}}, exports::BlenderVersion::v3});
    const auto correlated = exports::viewLobesBrdf({{0.3}, {0}, {{Rgb(0)}, {Rgb(1)}}, exports::BlenderVersion::v4});
    std::mt19937_64 random(3);
    for (int i = 0; i < 200; ++i) {
      const DirectionPair pair{test::randomUpper(random), test::randomUpper(random)};
      const double expected = model->evaluate(pair.wi, pair.wo).x;
      QVERIFY(std::abs(separable->evaluate(pair.wi, pair.wo).x - expected) < 1e-9 * (1 + expected));
      const double lobe = exports::correlatedGgx(models::surfaceGeometry(pair), exports::GgxAlpha(0.3));
      QVERIFY(std::abs(correlated->evaluate(pair.wi, pair.wo).x - lobe) < 1e-9 * (1 + lobe));
    }
  }

  /// What is such a sum of lobes is found again, at all angles of the viewer.
  void aSumOfLobesIsFound() {
    const auto material = exports::viewLobesBrdf(known());
    const auto fitted = exports::viewLobesBrdf(exports::fitViewLobes(*material, {.lobes = 4, .knots = 9}));
    std::mt19937_64 random(5);
    for (int i = 0; i < 500; ++i) {
      const DirectionPair pair{test::randomUpper(random), test::randomUpper(random)};
      const Rgb expected = material->evaluate(pair.wi, pair.wo), found = fitted->evaluate(pair.wi, pair.wo);
      for (int c = 0; c < 3; ++c) QVERIFY(std::abs(found[c] - expected[c]) < 0.03 * expected[c] + 1e-4);
    }
  }

  /// Weights are not negative, and the energy is that of the material where the lobes do not fit.
  void theAlbedoIsKept() {
    const auto material = test::ggx(Rgb(0.2, 0.1, 0.05), Rgb(0.9), 0.25, 0.05);
    const ViewLobes lobes = exports::fitViewLobes(*material, {.lobes = 2, .knots = 8});
    for (const auto& row : lobes.weights)
      for (const Rgb& weight : row) QVERIFY(weight.x >= 0 && weight.y >= 0 && weight.z >= 0);
    const auto fitted = exports::viewLobesBrdf(lobes);
    for (const double theta : {0.0, 30.0, 60.0}) {
      const double expected = directionalAlbedo(*material, radians(theta)).x;
      QVERIFY(std::abs(directionalAlbedo(*fitted, radians(theta)).x / expected - 1) < 0.03);
    }
  }

  void belowTheHorizonThereIsNothing() {
    const auto lobes = exports::viewLobesBrdf(known());
    QCOMPARE(lobes->evaluate(Direction(0, 0, -1), Direction(0, 0, 1)).x, 0.0);
    QCOMPARE(lobes->evaluate(Direction(1, 0, 0), Direction(-1, 0, 0)).x, 0.0);
  }
};

GONIO_TEST(ViewLobesTest)
}  // namespace view_lobes_test

#include "view_lobes_test.moc"
