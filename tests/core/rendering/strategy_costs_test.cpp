// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/strategy_costs.h"

#include <QTest>
#include <cmath>

#include "core/models/registry.h"
#include "core/rendering/scene_file.h"
#include "tests/support/test_program.h"

namespace strategy_costs_test {
using namespace gonio;
using namespace gonio::rendering;

/// A sphere under a small lamp, and nothing else.
std::vector<StrategyCost> costsOf(double roughness) {
  const models::Model& ggx = models::findModel("ggx");
  models::ParameterValues values = models::defaultParameters(ggx.spec());
  values.values[*ggx.spec().find("roughness")] = Rgb(roughness);
  values.values[*ggx.spec().find("diffuse")] = Rgb(0);
  const std::vector materials{std::make_shared<const RenderMaterial>(ggx.instantiate(values))};
  Scene shown = openScene("sphere-under-lamp");
  std::erase_if(shown.objects,
                [](const SceneObject& object) { return std::holds_alternative<Diffuse>(object.material); });
  const auto bound = bindMaterials(shown, materials);
  return measureStrategyCosts(shown, bound, planEffects(shown, bound),
                              {.width = 32, .height = 32, .samples = 16, .referenceSamples = 512});
}

class StrategyCostsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Veach's example: for a mirror-like surface draws from the lights alone are far worse than draws from the material,
  /// for a rough one under a small light the other way round; both together are near the better one each time.
  void eachStrategyFailsWhereItMust() {
    const auto sharp = costsOf(0.02), rough = costsOf(0.9);
    QCOMPARE(sharp.size(), std::size_t(3));
    QVERIFY(sharp[1].error > 2 * sharp[2].error && rough[2].error > 1.3 * rough[1].error);
    for (const auto& costs : {sharp, rough}) QVERIFY(costs[0].error < 1.2 * std::min(costs[1].error, costs[2].error));
  }

  /// The figures at equal time and equal error are those of the root law; of the strategy that they refer to its own.
  void equalTimeAndEqualErrorFollowTheRootLaw() {
    const auto costs = costsOf(0.3);
    QVERIFY(costs[0].strategy == PathTracer::Strategy::both && costs[0].seconds > 0 && costs[0].error > 0);
    QCOMPARE(costs[0].equalTimeError, costs[0].error);
    QCOMPARE(costs[0].equalErrorTime, costs[0].seconds);
    for (const StrategyCost& cost : costs) {
      QVERIFY(std::abs(cost.equalTimeError * cost.equalTimeError * costs[0].seconds -
                       cost.error * cost.error * cost.seconds) < 1e-12 * cost.error * cost.error * cost.seconds);
      QVERIFY(std::abs(cost.equalErrorTime * costs[0].error * costs[0].error - cost.seconds * cost.error * cost.error) <
              1e-12 * cost.seconds * cost.error * cost.error);
    }
  }
};

GONIO_TEST(StrategyCostsTest)
}  // namespace strategy_costs_test

#include "strategy_costs_test.moc"
