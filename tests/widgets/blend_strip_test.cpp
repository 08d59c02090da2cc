// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/interpolation/blend_strip.h"

#include <QPixmap>
#include <QSignalSpy>
#include <QTest>

using namespace gonio::widgets;

namespace {

QImage filled(const QColor& colour) {
  QImage image(64, 64, QImage::Format_RGBA8888);
  image.fill(colour);
  return image;
}

}  // namespace

class BlendStripTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<BlendStrip> m_strip;

 private Q_SLOTS:
  void init() {
    m_strip = std::make_unique<BlendStrip>();
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

  /// Without rows there is nothing to choose, and no crash.
  void theEmptyStrip() {
    m_strip->setRows({});
    m_strip->setEmptyText("Fill A and B.");
    QSignalSpy chosen(m_strip.get(), &BlendStrip::chosen);
    QTest::mouseClick(m_strip.get(), Qt::LeftButton, {}, QPoint(100, 100));
    for (const auto key : {Qt::Key_Down, Qt::Key_Return}) QTest::keyClick(m_strip.get(), key);
    m_strip->grab();
    QCOMPARE(chosen.count(), 0);
  }
};

QTEST_MAIN(BlendStripTest)
#include "blend_strip_test.moc"
