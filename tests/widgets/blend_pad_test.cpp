// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/interpolation/blend_pad.h"

#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <numeric>

#include "tests/support/test_program.h"

namespace blend_pad_test {
using namespace gonio;
using namespace gonio::widgets;

double distance(const QPointF& a, const QPointF& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

/// Places over and beyond the pad.
std::vector<QPointF> places() {
  std::vector<QPointF> result;
  for (int i = -6; i <= 16; ++i)
    for (int j = -6; j <= 16; ++j) result.push_back({i / 10.0, j / 10.0});
  return result;
}

class BlendPadTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<BlendPad> m_pad;

  void makePad(int materials) {
    m_pad = std::make_unique<BlendPad>();
    m_pad->setCorners(std::vector<BlendCorner>(std::size_t(materials)));
    m_pad->resize(400, 400);
    m_pad->show();
    m_pad->setFocus();
  }
  QPoint at(const QPointF& place) const { return m_pad->position(place).toPoint(); }

 private Q_SLOTS:
  /// Weights are fractions of a whole, wherever the hand is: core takes no others.
  void weightsAreSharesOfOne() {
    for (int n = minBlended; n <= maxBlended; ++n)
      for (const QPointF& place : places()) {
        const std::vector<double> weights = weightsAt(n, nearestPosition(n, place));
        QCOMPARE(weights.size(), std::size_t(n));
        for (const double w : weights) QVERIFY(w >= 0 && w <= 1);
        QVERIFY(std::abs(std::accumulate(weights.begin(), weights.end(), 0.0) - 1) < 1e-15);
      }
  }

  /// A corner is that material and nothing else, to the bit; so is every place beyond it.
  void cornersAreExact() {
    for (int n = minBlended; n <= maxBlended; ++n)
      for (int corner = 0; corner < n; ++corner) {
        std::vector<double> alone(std::size_t(n), 0.0);
        alone[std::size_t(corner)] = 1;
        QVERIFY(weightsAt(n, cornerPosition(corner)) == alone);
        QPointF centre;
        for (int i = 0; i < n; ++i) centre += drawnCorners(n)[std::size_t(i)] / n;
        const QPointF beyond = centre + 1.7 * (drawnCorners(n)[std::size_t(corner)] - centre);
        QVERIFY(weightsAt(n, nearestPosition(n, positionDrawnAt(n, beyond))) == alone);
      }
  }

  /// Barycentric and bilinear weights give the drawn point back from the drawn corners.
  void weightsSpanThePlace() {
    for (int n = minBlended; n <= maxBlended; ++n) {
      const std::vector<QPointF> corners = drawnCorners(n);
      for (const QPointF& any : places()) {
        const QPointF place = nearestPosition(n, any);
        QPointF sum;
        for (std::size_t i = 0; i < corners.size(); ++i) sum += weightsAt(n, place)[i] * corners[i];
        QVERIFY(distance(sum, drawnAt(n, place)) < 1e-14);
        QVERIFY(distance(positionDrawnAt(n, sum), place) < 1e-14);
      }
      for (const double w : weightsAt(n, centrePosition(n))) QVERIFY(std::abs(w - 1.0 / n) < 1e-15);
    }
  }

  /// The nearest place is: brute force over all that there are. Places of the pad are their own.
  void theNearestPlaceIsNearest() {
    for (int n = minBlended; n <= maxBlended; ++n)
      for (const QPointF& any : places()) {
        const QPointF drawn = drawnAt(n, any), found = nearestPosition(n, any);
        QVERIFY(distance(nearestPosition(n, found), found) < 1e-15);
        const double away = distance(drawnAt(n, found), drawn);
        for (const QPointF& other : places()) {
          const QPointF inside = n == 2 ? QPointF(other.x(), 0) : other;
          const bool exists = inside.x() >= 0 && inside.y() >= 0 &&
                              (n == 3 ? inside.x() + inside.y() <= 1 : inside.x() <= 1 && inside.y() <= 1);
          // Along a line only what lies on it counts.
          const QPointF from = n == 2 ? drawnAt(2, {any.x(), 0}) : drawn;
          if (exists)
            QVERIFY((n == 2 ? distance(drawnAt(2, found), from) : away) <= distance(drawnAt(n, inside), from) + 1e-12);
        }
      }
  }

  /// The strip's way begins at the first material and stays where there are places.
  void theWayOfTheStrip() {
    for (int n = minBlended; n <= maxBlended; ++n) {
      QVERIFY(weightsAt(n, pathPosition(n, 0))[0] == 1);
      for (const double t : {0.0, 0.3, 1.0})
        QVERIFY(distance(nearestPosition(n, pathPosition(n, t)), pathPosition(n, t)) < 1e-15);
      QVERIFY(weightsAt(n, pathPosition(n, 1))[0] == 0);
    }
    QVERIFY(weightsAt(4, pathPosition(4, 1))[3] == 1);
    QVERIFY(weightsAt(3, pathPosition(3, 1)) == (std::vector{0.0, 0.5, 0.5}));
  }

  /// The point goes where the mouse is, step by step, in one interaction.
  void aDragMovesThePoint() {
    for (const int n : {3, 4}) {
      makePad(n);
      QSignalSpy started(m_pad.get(), &BlendPad::interactionStarted), ended(m_pad.get(), &BlendPad::interactionEnded);
      QSignalSpy edited(m_pad.get(), &BlendPad::placeEdited);
      const QPointF wanted(0.4, 0.3);
      QTest::mousePress(m_pad.get(), Qt::LeftButton, {}, at({0.2, 0.2}));
      QTest::mouseMove(m_pad.get(), at({0.3, 0.2}));
      QTest::mouseMove(m_pad.get(), at(wanted));
      QCOMPARE(edited.count(), 3);
      QVERIFY(distance(m_pad->position(m_pad->place()), at(wanted)) < 1e-9);
      QCOMPARE(ended.count(), 0);
      QTest::mouseRelease(m_pad.get(), Qt::LeftButton, {}, at(wanted));
      QCOMPARE(started.count(), 1);
      QCOMPARE(ended.count(), 1);
      // Near a corner it sticks to it: the material alone can be had by hand.
      QTest::mouseClick(m_pad.get(), Qt::LeftButton, {}, at(cornerPosition(n - 1)) + QPoint(3, -2));
      QVERIFY(m_pad->place() == cornerPosition(n - 1));
      QTest::mouseDClick(m_pad.get(), Qt::LeftButton, {}, at({0.1, 0.1}));
      QVERIFY(m_pad->place() == centrePosition(n));
    }
  }

  void aFineDragGoesATenthAsFar() {
    makePad(4);
    m_pad->setPlace({0.5, 0.5});
    const QPointF before = m_pad->position(m_pad->place());
    QTest::mousePress(m_pad.get(), Qt::LeftButton, Qt::ShiftModifier, QPoint(100, 100));
    QVERIFY(m_pad->place() == QPointF(0.5, 0.5));
    QMouseEvent move(QEvent::MouseMove, QPointF(160, 130), m_pad->mapToGlobal(QPointF(160, 130)), Qt::LeftButton,
                     Qt::LeftButton, Qt::ShiftModifier);
    QApplication::sendEvent(m_pad.get(), &move);
    QVERIFY(distance(m_pad->position(m_pad->place()), before + QPointF(6, 3)) < 1e-9);
    QTest::keyClick(m_pad.get(), Qt::Key_Escape);
    QVERIFY(m_pad->place() == QPointF(0.5, 0.5));
  }

  void keysMoveThePoint() {
    makePad(3);
    m_pad->setPlace(centrePosition(3));
    QSignalSpy edited(m_pad.get(), &BlendPad::placeEdited);
    const QPointF before = drawnAt(3, m_pad->place());
    QTest::keyClick(m_pad.get(), Qt::Key_Left);
    QVERIFY(distance(drawnAt(3, m_pad->place()), before - QPointF(0.02, 0)) < 1e-12);
    QTest::keyClick(m_pad.get(), Qt::Key_Down, Qt::ShiftModifier);
    QVERIFY(distance(drawnAt(3, m_pad->place()), before + QPointF(-0.02, 0.002)) < 1e-12);
    QTest::keyClick(m_pad.get(), Qt::Key_2);
    QVERIFY(m_pad->weights() == (std::vector{0.0, 1.0, 0.0}));
    QVERIFY(m_pad->accessibleDescription().contains("B 100 %"));
    QTest::keyClick(m_pad.get(), Qt::Key_Home);
    QVERIFY(m_pad->place() == centrePosition(3));
    QCOMPARE(edited.count(), 4);
    QTest::keyClick(m_pad.get(), Qt::Key_4);  // there is no fourth
    QCOMPARE(edited.count(), 4);
    for (int i = 0; i < 100; ++i) QTest::keyClick(m_pad.get(), Qt::Key_Up);
    QVERIFY(m_pad->weights() == (std::vector{1.0, 0.0, 0.0}));
  }

  /// Another count of materials: the place goes to the nearest that there is; showing a place reports nobody.
  void thePlaceFollowsTheCorners() {
    makePad(4);
    QSignalSpy edited(m_pad.get(), &BlendPad::placeEdited);
    m_pad->setPlace({1, 1});
    m_pad->setCorners(std::vector<BlendCorner>(3));
    QVERIFY(m_pad->weights() == (std::vector{0.0, 0.5, 0.5}));
    m_pad->setPlace({7, -3});
    QVERIFY(m_pad->weights()[1] == 1);
    QCOMPARE(edited.count(), 0);
  }

  void weightsAreRead() {
    QCOMPARE(weightText(0), QStringLiteral("0 %"));
    QCOMPARE(weightText(1), QStringLiteral("100 %"));
    QCOMPARE(weightText(0.403), QStringLiteral("40 %"));
    QCOMPARE(weightText(0.004), QStringLiteral("0.4 %"));
    QCOMPARE(weightText(0.998), QStringLiteral("99.8 %"));
  }
};

GONIO_TEST(BlendPadTest)
}  // namespace blend_pad_test

#include "blend_pad_test.moc"
