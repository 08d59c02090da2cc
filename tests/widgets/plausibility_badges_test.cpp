// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/plausibility_badges.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "tests/support/test_program.h"

namespace plausibility_badges_test {
using namespace gonio;
using namespace gonio::widgets;
using metrics::PlausibilityCheck;

std::vector<PlausibilityCheck> checks() {
  PlausibilityCheck energy{.name = "energy", .passed = false, .worst = 1.4, .limit = 1.01, .fraction = 0.3};
  energy.at = DirectionPair{{0, 0, 1}, fromSpherical(radians(75), 0)};
  PlausibilityCheck negative{.name = "negative", .passed = false, .worst = 0.02};
  negative.at = DirectionPair{fromSpherical(radians(30), 0), fromSpherical(radians(60), pi)};
  return {energy, {.name = "reciprocity"}, negative, {.name = "non-finite"}, {.name = "extrapolated"}};
}

class PlausibilityBadgesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The word and the state are given to those who see no colour and to screen readers.
  void badgesTellTheirState() {
    PlausibilityBadges badges;
    badges.setChecks(checks());
    QCOMPARE(badges.badgeCount(), std::size_t(5));
    QCOMPARE(badges.badge(0)->state(), PlausibilityBadge::State::failed);
    QCOMPARE(badges.badge(1)->state(), PlausibilityBadge::State::passed);
    QVERIFY(badges.badge(0)->accessibleName().contains("failed"));
    QVERIFY(badges.badge(1)->accessibleName().contains("passed"));
    badges.setPending();
    QCOMPARE(badges.badge(0)->state(), PlausibilityBadge::State::unknown);
  }

  /// By keyboard: Space opens what it means, the worst value and its angle; again closes it.
  void aPressExplains() {
    PlausibilityBadges badges;
    badges.setChecks(checks());
    badges.show();
    QVERIFY(badges.explanation()->isHidden());
    QTest::keyClick(badges.badge(0), Qt::Key_Space);
    QVERIFY(badges.explanation()->isVisible());
    QVERIFY(badges.explanation()->text().contains("1.4") && badges.explanation()->text().contains("75"));
    // Another one takes its place.
    QTest::mouseClick(badges.badge(1), Qt::LeftButton);
    QVERIFY(!badges.badge(0)->isChecked());
    QVERIFY(badges.explanation()->text().contains("Passed") && badges.showButton()->isHidden());
    QTest::keyClick(badges.badge(1), Qt::Key_Space);
    QVERIFY(badges.explanation()->isHidden());
  }

  /// "Show" names the check and the angle at which light falls in.
  void showTellsWhere() {
    PlausibilityBadges badges;
    badges.setChecks(checks());
    QSignalSpy wanted(&badges, &PlausibilityBadges::showRequested);
    badges.badge(0)->click();
    badges.showButton()->click();
    QCOMPARE(wanted.back().front().toString(), "energy");
    QVERIFY(std::abs(wanted.back().back().toDouble() - radians(75)) < 1e-9);
    badges.badge(2)->click();
    badges.showButton()->click();
    QCOMPARE(wanted.back().front().toString(), "negative");
    QVERIFY(std::abs(wanted.back().back().toDouble() - radians(30)) < 1e-9);
  }

  void nothingOpenIsSaid() {
    PlausibilityBadges badges;
    badges.setChecks(checks());
    badges.badge(0)->click();
    badges.clear();
    QVERIFY(badges.explanation()->isHidden() && badges.badge(0)->isHidden());
    QVERIFY(!badges.findChild<QLabel*>()->isHidden());
  }
};

GONIO_TEST(PlausibilityBadgesTest)
}  // namespace plausibility_badges_test

#include "plausibility_badges_test.moc"
