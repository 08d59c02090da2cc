// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/effect_list.h"

#include <QLabel>
#include <QTest>

#include "tests/support/test_program.h"

namespace effect_list_test {
using namespace gonio;
using widgets::EffectList;

class EffectListTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// A cost is a time and its fraction of the picture's; one that is not above its uncertainty gives no figure.
  void costsAreTimesUnlessTheyAreNoise() {
    EffectCosts costs{.seconds = 0.2, .effects = {}};
    for (std::size_t i = 0; i < effectCount; ++i) costs.effects.push_back({.effect = Effect(i)});
    costs.effects[std::size_t(Effect::castShadows)] = {
        .effect = Effect::castShadows, .seconds = 0.05, .secondsNoise = 0.01, .difference = 0.02, .noise = 0.001};
    costs.effects[std::size_t(Effect::interreflection)] = {
        .effect = Effect::interreflection, .seconds = -0.004, .secondsNoise = 0.01};
    EffectList list;
    const auto costOf = [&](Effect effect) -> const QLabel& {
      return *list.findChildren<QLabel*>("cost").at(int(effect));
    };
    QCOMPARE(costOf(Effect::castShadows).text(), "-");
    list.setCosts(costs);
    QCOMPARE(costOf(Effect::castShadows).text(), "50.0 ms (25 %)");
    QCOMPARE(costOf(Effect::castShadows).toolTip(),
             "CPU time that the effect adds to the image: 50.0 ± 10.0 ms. The effect "
             "changes the image by 2 %; noise alone changes it by 0.1 %.");
    QCOMPARE(costOf(Effect::interreflection).text(), "within noise");
    list.setCosts(std::nullopt);
    QCOMPARE(costOf(Effect::castShadows).text(), "-");
  }
};

GONIO_TEST(EffectListTest)
}  // namespace effect_list_test

#include "effect_list_test.moc"
