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

PlausibilityBadge* badge(const PlausibilityBadges& badges, int check) {
  return badges.findChildren<PlausibilityBadge*>().at(check);
}
const QLabel& explanation(const PlausibilityBadges& badges) { return *badges.findChild<QLabel*>("explanation"); }
QPushButton* showButton(const PlausibilityBadges& badges) { return badges.findChild<QPushButton*>(); }

class PlausibilityBadgesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The word and the state are given to those who see no colour and to screen readers.
  void badgesTellTheirState() {
    PlausibilityBadges badges;
    badges.setChecks(checks());
    QCOMPARE(badges.findChildren<PlausibilityBadge*>().size(), 5);
    QCOMPARE(badge(badges, 0)->state(), PlausibilityBadge::State::failed);
    QCOMPARE(badge(badges, 1)->state(), PlausibilityBadge::State::passed);
    QVERIFY(badge(badges, 0)->accessibleName().contains("failed"));
    QVERIFY(badge(badges, 1)->accessibleName().contains("passed"));
    badges.setPending();
    QCOMPARE(badge(badges, 0)->state(), PlausibilityBadge::State::unknown);
  }

  /// A measurement that is not reciprocal is no fault of the user's; an edited one is marked, and so are other
  /// failures.
  void anUntouchedMeasurementIsNotBlamed() {
    std::vector<metrics::PlausibilityCheck> failed = checks();
    for (auto& check : failed) check.passed = false;
    PlausibilityBadges badges;
    badges.setChecks(failed, true);
    for (std::size_t i = 0; i < failed.size(); ++i)
      QCOMPARE(badge(badges, int(i))->state(),
               failed[i].name == "reciprocity" ? PlausibilityBadge::State::inherent : PlausibilityBadge::State::failed);
    badges.setChecks(failed);
    for (std::size_t i = 0; i < failed.size(); ++i)
      QCOMPARE(badge(badges, int(i))->state(), PlausibilityBadge::State::failed);
  }

  /// By keyboard: Space opens what it means, the worst value and its angle; again closes it.
  void aPressExplains() {
    PlausibilityBadges badges;
    badges.setChecks(checks());
    badges.show();
    QVERIFY(explanation(badges).isHidden());
    QTest::keyClick(badge(badges, 0), Qt::Key_Space);
    QVERIFY(explanation(badges).isVisible());
    QVERIFY(explanation(badges).text().contains("1.4") && explanation(badges).text().contains("75"));
    // Another one takes its place.
    QTest::mouseClick(badge(badges, 1), Qt::LeftButton);
    QVERIFY(!badge(badges, 0)->isChecked());
    QVERIFY(explanation(badges).text().contains("Passed") && showButton(badges)->isHidden());
    QTest::keyClick(badge(badges, 1), Qt::Key_Space);
    QVERIFY(explanation(badges).isHidden());
  }

  /// "Show" names the check and the angle at which light falls in.
  void showTellsWhere() {
    PlausibilityBadges badges;
    badges.setChecks(checks());
    QSignalSpy wanted(&badges, &PlausibilityBadges::showRequested);
    badge(badges, 0)->click();
    showButton(badges)->click();
    QCOMPARE(wanted.back().front().toString(), "energy");
    QVERIFY(std::abs(wanted.back().back().toDouble() - radians(75)) < 1e-9);
    badge(badges, 2)->click();
    showButton(badges)->click();
    QCOMPARE(wanted.back().front().toString(), "negative");
    QVERIFY(std::abs(wanted.back().back().toDouble() - radians(30)) < 1e-9);
  }

  void nothingOpenIsSaid() {
    PlausibilityBadges badges;
    badges.setChecks(checks());
    badge(badges, 0)->click();
    badges.clear();
    QVERIFY(explanation(badges).isHidden() && badge(badges, 0)->isHidden());
    QVERIFY(!badges.findChild<QLabel*>()->isHidden());
  }
};

GONIO_TEST(PlausibilityBadgesTest)
}  // namespace plausibility_badges_test

#include "plausibility_badges_test.moc"
