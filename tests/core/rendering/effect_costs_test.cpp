// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/effect_costs.h"

#include <QTest>

#include "core/rendering/scene_file.h"
#include "tests/core/rendering/tracing.h"
#include "tests/support/test_program.h"

namespace effect_costs_test {
using namespace gonio;
using namespace gonio::rendering;
using namespace gonio::test;

const Material grey = diffuseMaterial(Rgb(0.5));
constexpr EffectCostOptions small{.width = 16, .height = 16, .samples = 16, .repeats = 1};

EffectCosts measure(const char* name, const EffectOverrides& overrides = {}, const EffectCostOptions& options = small,
                    const TaskControl& control = {}) {
  const Scene scene = openScene(name);
  return measureEffectCosts(scene, bindMaterials(scene, std::vector<Material>(2, grey)), overrides, options, control);
}

/// What effects change; times are printed, not tested.
class EffectCostsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Effects that are called for change the picture by more than chance, others not at all or by chance.
  void whatIsCalledForChangesThePicture() {
    const EffectCosts costs = measure("bowl");
    QCOMPARE(costs.effects.size(), effectCount);
    for (std::size_t i = 0; i < effectCount; ++i) {
      const EffectCost& cost = costs.effects[i];
      QCOMPARE(cost.effect, Effect(i));
      QVERIFY(std::isfinite(cost.seconds) && cost.secondsNoise >= 0 && cost.noise > 0);
      const bool matters = cost.effect == Effect::environmentLight || cost.effect == Effect::selfShadowing ||
                           cost.effect == Effect::interreflection;
      QVERIFY2(matters ? cost.difference > 0.03 : cost.difference < 2 * cost.noise, effectId(cost.effect));
    }
    QCOMPARE(costs.effects[std::size_t(Effect::directLight)].difference, 0.0);
    QVERIFY(std::abs(costs.effects[std::size_t(Effect::environmentLight)].difference - 1) < 1e-12);
    QVERIFY(costs.seconds > 0);
  }

  /// A time counts where it is larger than its uncertainty, whatever its sign.
  void timesWithinTheirNoise() {
    const auto within = [](double seconds, double noise) {
      return EffectCost{.effect = Effect::directLight, .seconds = seconds, .secondsNoise = noise}.isWithinNoise();
    };
    QVERIFY(within(0.01, 0.02) && within(-0.01, 0.02) && within(0, 0));
    QVERIFY(!within(0.03, 0.02) && !within(-0.03, 0.02));
  }

  /// Around what the user forces, and the thresholds that are asked for.
  void aroundThePlanThatIsAskedFor() {
    EffectOverrides overrides;
    overrides[std::size_t(Effect::environmentLight)] = false;
    const EffectCosts dark = measure("bowl", overrides);
    QCOMPARE(dark.effects[std::size_t(Effect::interreflection)].difference, 0.0);
    EffectCostOptions direct = small;
    direct.thresholds.remainder = 100;
    QCOMPARE(measure("two-spheres", {}, direct).effects[std::size_t(Effect::interreflection)].noise,
             measure("two-spheres",
                     [] {
                       EffectOverrides off;
                       off[std::size_t(Effect::interreflection)] = false;
                       return off;
                     }())
                 .effects[std::size_t(Effect::interreflection)]
                 .noise);
  }

  void progressAndCancel() {
    double last = 0;
    int calls = 0;
    measure("sphere", {}, small, {{}, [&](double fraction) {
                                    QVERIFY(fraction >= last && fraction <= 1);
                                    last = fraction;
                                    ++calls;
                                  }});
    QVERIFY(last == 1 && calls >= int(effectCount));
    std::stop_source source;
    source.request_stop();
    QVERIFY_THROWS_EXCEPTION(Cancelled, measure("sphere", {}, small, {source.get_token(), {}}));
  }
};

GONIO_TEST(EffectCostsTest)
}  // namespace effect_costs_test

#include "effect_costs_test.moc"
