// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/interpolation/blend_strip.h"

#include <QPaintEvent>
#include <QPixmap>
#include <QSignalSpy>
#include <QTest>
#include <utility>

#include "tests/support/test_program.h"
#include "widgets/interpolation/sphere_picture.h"

namespace blend_strip_test {
using namespace gonio::widgets;

QImage filled(const QColor& colour) {
  QImage image(64, 64, QImage::Format_RGBA8888);
  image.fill(colour);
  return image;
}

/// Remembers what it was asked to paint.
class WatchedStrip final : public BlendStrip {
 public:
  QRegion painted() { return std::exchange(m_painted, {}); }

 protected:
  void paintEvent(QPaintEvent* event) override {
    m_painted += event->region();
    BlendStrip::paintEvent(event);
  }

 private:
  QRegion m_painted;
};

class BlendStripTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<WatchedStrip> m_strip;

 private Q_SLOTS:
  void init() {
    m_strip = std::make_unique<WatchedStrip>();
    m_strip->setSteps({"0", "1/2", "1"});
    m_strip->setRows(
        {{"Linear", "The reflectances", std::vector<QImage>(3)}, {"Factors", "The curves", std::vector<QImage>(3)}});
    m_strip->resize(500, 260);
    m_strip->show();
  }

  /// Each picture is drawn in its own cell, and nowhere else.
  void picturesLieInTheirCells() {
    m_strip->setCurrentRow(1);
    m_strip->setRow(0, {"Linear", "", {filled(Qt::red), filled(Qt::green), {}}});
    const QImage seen = m_strip->grab().toImage();
    const auto at = [&](int row, int step) {
      return seen.pixelColor((m_strip->cell(row, step).center() * seen.devicePixelRatio()).toPoint());
    };
    QCOMPARE(at(0, 0), QColor(Qt::red));
    QCOMPARE(at(0, 1), QColor(Qt::green));
    for (const auto& [row, step] : {std::pair(0, 2), {1, 0}, {1, 1}, {1, 2}})
      QVERIFY(at(row, step) != QColor(Qt::red) && at(row, step) != QColor(Qt::green));
    for (int row = 0; row < 2; ++row)
      for (int step = 0; step < 3; ++step) QVERIFY(QRectF(m_strip->rect()).contains(m_strip->cell(row, step)));
  }

  void aClickChooses() {
    QSignalSpy chosen(m_strip.get(), &BlendStrip::chosen);
    QTest::mouseClick(m_strip.get(), Qt::LeftButton, {}, m_strip->cell(1, 2).center().toPoint());
    QCOMPARE(chosen.last(), (QVariantList{1, 2}));
    // On the name: the way alone.
    QTest::mouseClick(m_strip.get(), Qt::LeftButton, {}, QPoint(4, int(m_strip->cell(1, 0).center().y())));
    QCOMPARE(chosen.last(), (QVariantList{1, -1}));
    QTest::mouseClick(m_strip.get(), Qt::LeftButton, {}, QPoint(4, 2));
    QCOMPARE(chosen.count(), 2);
  }

  void keysChoose() {
    QSignalSpy chosen(m_strip.get(), &BlendStrip::chosen);
    m_strip->setFocus();
    QTest::keyClick(m_strip.get(), Qt::Key_Right);
    QTest::keyClick(m_strip.get(), Qt::Key_Down);
    for (int i = 0; i < 5; ++i) QTest::keyClick(m_strip.get(), Qt::Key_Down);  // not beyond the last
    QCOMPARE(m_strip->accessibleDescription(), QStringLiteral("Factors at 1/2"));
    QTest::keyClick(m_strip.get(), Qt::Key_Return);
    QCOMPARE(chosen.last(), (QVariantList{1, 1}));
    QCOMPARE(chosen.count(), 1);
  }

  /// Under the hand only the line of the mark is painted, and nothing when nothing changes; a row is painted alone.
  void paintsWhatChanged() {
    m_strip->setMark(0.25);
    QVERIFY(QTest::qWaitForWindowExposed(m_strip.get()));
    const auto change = [this](const auto& how) {
      QCoreApplication::processEvents();
      m_strip->painted();
      how();
      QCoreApplication::processEvents();
      return m_strip->painted().boundingRect();
    };
    const int firstRow = int(m_strip->cell(0, 0).top()), secondRow = int(m_strip->cell(1, 0).top());
    const QRect mark = change([this] { m_strip->setMark(0.5); });
    QVERIFY(!mark.isEmpty() && mark.bottom() < firstRow);
    QVERIFY(change([this] { m_strip->setMark(0.5); }).isEmpty());
    QVERIFY(change([this] { m_strip->setCurrentRow(0); }).isEmpty());
    const QRect row = change([this] { m_strip->setRow(1, {"Factors", "", {filled(Qt::red), {}, {}}}); });
    QVERIFY(!row.isEmpty() && row.top() >= secondRow - 3 && row.bottom() <= int(m_strip->cell(1, 0).bottom()) + 3);
    const QRect both = change([this] { m_strip->setCurrentRow(1); });
    QVERIFY(both.top() <= firstRow && both.bottom() >= secondRow);
    // A longer name moves the columns of all rows.
    QCOMPARE(change([this] {
               m_strip->setRow(1, {"A much longer name", "", std::vector<QImage>(3)});
             }),
             m_strip->rect());
  }

  /// A part that is painted anew is what a painting of the whole gives.
  void partsMeetTheWhole() {
    m_strip->setRow(0, {"Linear", "", {filled(Qt::red), filled(Qt::green), filled(Qt::blue)}});
    const QImage before = m_strip->grab().toImage();
    m_strip->setMark(0.5);
    QImage parts = before;
    m_strip->render(&parts, m_strip->cell(1, 0).topLeft().toPoint(),
                    QRect(m_strip->cell(1, 0).topLeft().toPoint(), QSize(60, 40)));
    QCOMPARE(parts, before);
    const QRect header(0, 0, m_strip->width(), int(m_strip->cell(0, 0).top()));
    m_strip->render(&parts, {}, header);
    QVERIFY(parts != before);
    QCOMPARE(parts, m_strip->grab().toImage());
  }

  /// A picture is scaled once for every size.
  void picturesAreScaledOnce() {
    const QImage picture = filled(Qt::red);
    const QPixmap first = sphereAtSize(picture, {20, 20});
    QCOMPARE(first.size(), QSize(20, 20));
    QCOMPARE(sphereAtSize(picture, {20, 20}).cacheKey(), first.cacheKey());
    QCOMPARE(sphereAtSize(picture, {30, 30}).size(), QSize(30, 30));
    QCOMPARE(sphereAtSize(filled(Qt::green), {20, 20}).toImage().pixelColor(9, 9), QColor(Qt::green));
  }

  /// Without rows there is nothing to choose, and no crash.
  void theEmptyStrip() {
    m_strip->setRows({});
    m_strip->setEmptyText("Fill A and B.");
    QSignalSpy chosen(m_strip.get(), &BlendStrip::chosen);
    QTest::mouseClick(m_strip.get(), Qt::LeftButton, {}, QPoint(100, 100));
    for (const auto key : {Qt::Key_Down, Qt::Key_Return}) QTest::keyClick(m_strip.get(), key);
    QCOMPARE(chosen.count(), 0);
    // Nothing is left of the rows: it looks like one that never had any.
    BlendStrip other;
    other.setSteps({"0", "1/2", "1"});
    other.setEmptyText("Fill A and B.");
    other.resize(m_strip->size());
    m_strip->clearFocus();
    QCOMPARE(m_strip->grab().toImage(), other.grab().toImage());
  }
};

GONIO_TEST(BlendStripTest)
}  // namespace blend_strip_test

#include "blend_strip_test.moc"
