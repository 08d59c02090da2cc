// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/icons.h"

#include <QApplication>
#include <QDir>
#include <QPainter>
#include <QTest>

#include "tests/support/test_program.h"

namespace icons_test {
using namespace gonio::widgets;

class IconsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Each icon draws something inside its rectangle, in the colour of the pen alone.
  void drawInOneColour() {
    const QStringList files = QDir(QStringLiteral(":/icons")).entryList({QStringLiteral("*.svg")});
    QVERIFY(files.size() > 40);
    const QColor colour(200, 60, 20);
    for (const QString& file : files) {
      constexpr int side = 64, margin = 8;
      QImage image(side + 2 * margin, side + 2 * margin, QImage::Format_ARGB32);
      image.fill(Qt::transparent);
      QPainter painter(&image);
      painter.setPen(colour);
      paintIcon(painter, QString(file).chopped(4), QRectF(margin, margin, side, side));
      painter.end();
      int drawn = 0;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
          const QColor pixel = image.pixelColor(x, y);
          if (pixel.alpha() == 0) continue;
          ++drawn;
          QVERIFY2(x >= margin && y >= margin && x < side + margin && y < side + margin, qPrintable(file));
          if (pixel.alpha() == 255) QVERIFY2(pixel.rgb() == colour.rgb(), qPrintable(file));
        }
      QVERIFY2(drawn > 20 && drawn < side * side * 3 / 4, qPrintable(file));
    }
  }

  /// An icon follows the palette, and is paler on a disabled button.
  void followsThePalette() {
    const QPalette before = QApplication::palette();
    const QIcon icon = themedIcon(QStringLiteral("close"));
    for (const QColor& colour : {QColor(240, 240, 240), QColor(20, 20, 20)}) {
      QPalette palette = before;
      palette.setColor(QPalette::Active, QPalette::ButtonText, colour);
      QColor faint = colour;
      faint.setAlpha(100);
      palette.setColor(QPalette::Disabled, QPalette::ButtonText, faint);
      QApplication::setPalette(palette);
      const QImage enabled = icon.pixmap(64, 64, QIcon::Normal).toImage(),
                   disabled = icon.pixmap(64, 64, QIcon::Disabled).toImage();
      const QPoint middle = enabled.rect().center();
      QCOMPARE(enabled.pixelColor(middle), colour);
      QCOMPARE(icon.pixmap(64, 64, QIcon::Selected).toImage().pixelColor(middle),
               palette.color(QPalette::HighlightedText));
      QVERIFY(std::abs(disabled.pixelColor(middle).alpha() - 100) <= 2);
    }
    QApplication::setPalette(before);
  }
};

GONIO_TEST(IconsTest)
}  // namespace icons_test

#include "icons_test.moc"
