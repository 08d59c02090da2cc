// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/effect_list.h"

#include <QLabel>
#include <QTest>

#include "tests/support/test_program.h"

namespace effect_list_test {
using namespace gonio;
using namespace gonio::rendering;
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
    const QList<QLabel*> labels = list.findChildren<QLabel*>("cost");
    const QLabel &shadows = *labels.at(int(Effect::castShadows)),
                 &reflections = *labels.at(int(Effect::interreflection));
    const QString none = shadows.text();
    QVERIFY(!none.contains(QRegularExpression("[0-9]")));
    list.setCosts(costs);
    // 0.05 s of 0.2 s; the tip has the noise of both, too.
    QVERIFY2(shadows.text().contains("50.0 ms") && shadows.text().contains("25 %"), qPrintable(shadows.text()));
    for (const char* number : {"50.0 ± 10.0 ms", " 2 %", " 0.1 %"})
      QVERIFY2(shadows.toolTip().contains(number), qPrintable(shadows.toolTip()));
    QVERIFY(reflections.text() != none && !reflections.text().contains(QRegularExpression("[0-9]")));
    list.setCosts(std::nullopt);
    QCOMPARE(shadows.text(), none);
    QCOMPARE(reflections.text(), none);
  }
};

GONIO_TEST(EffectListTest)
}  // namespace effect_list_test

#include "effect_list_test.moc"
