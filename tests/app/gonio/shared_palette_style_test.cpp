// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/theme.h"

#include <QApplication>
#include <QCommonStyle>
#include <QIcon>
#include <QPixmap>
#include <QPushButton>
#include <QStyleOption>
#include <QTest>

#include "tests/support/test_program.h"

namespace shared_palette_style_test {
using namespace gonio::app;

/// Notes the palettes that it is to draw with.
struct PaletteRecorder : QCommonStyle {
  mutable QList<QPalette> palettes;
  mutable QString comboText;
  void drawPrimitive(PrimitiveElement, const QStyleOption* option, QPainter*, const QWidget*) const override {
    palettes << option->palette;
  }
  void drawControl(ControlElement, const QStyleOption* option, QPainter*, const QWidget*) const override {
    palettes << option->palette;
    if (const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option)) comboText = box->currentText;
  }
  void drawComplexControl(ComplexControl, const QStyleOptionComplex* option, QPainter*, const QWidget*) const override {
    palettes << option->palette;
  }
};

class SharedPaletteStyleTest : public QObject {
  Q_OBJECT

  static QPalette paletteOf(QColor text) {
    QPalette palette;
    palette.setColor(QPalette::Text, text);
    return palette;
  }

 private Q_SLOTS:
  void equalPalettesBecomeOne() {
    auto* recorder = new PaletteRecorder;
    const SharedPaletteStyle style(recorder);
    const QPalette red = paletteOf(Qt::red), alsoRed = paletteOf(Qt::red), blue = paletteOf(Qt::blue);
    QVERIFY(red.cacheKey() != alsoRed.cacheKey());
    QStyleOptionComplex option;
    for (const QPalette& palette : {red, alsoRed, blue}) {
      option.palette = palette;
      option.palette.setCurrentColorGroup(QPalette::Disabled);
      style.drawPrimitive(QStyle::PE_Frame, &option, nullptr);
      option.palette = palette;
      style.drawControl(QStyle::CE_PushButton, &option, nullptr);
      option.palette = palette;
      style.drawComplexControl(QStyle::CC_Slider, &option, nullptr);
    }
    QCOMPARE(recorder->palettes.size(), 9);
    for (qsizetype i = 0; i < 9; ++i) {
      const QPalette& drawn = recorder->palettes[i];
      QCOMPARE(drawn.cacheKey(), i < 6 ? red.cacheKey() : blue.cacheKey());
      QCOMPARE(drawn.currentColorGroup(), i % 3 == 0 ? QPalette::Disabled : QPalette::Active);
      QCOMPARE(drawn.color(QPalette::Text), i < 6 ? QColor(Qt::red) : QColor(Qt::blue));
    }
  }

  /// However many palettes there are, each is drawn with its own colours.
  void manyPalettesKeepTheirColours() {
    auto* recorder = new PaletteRecorder;
    const SharedPaletteStyle style(recorder);
    QStyleOption option;
    for (int i = 0; i < 120; ++i) {
      option.palette = paletteOf(QColor(i, 0, 0));
      style.drawPrimitive(QStyle::PE_Frame, &option, nullptr);
      QCOMPARE(recorder->palettes.back().color(QPalette::Text), QColor(i, 0, 0));
    }
  }

  /// A name that is too long for its box ends with an ellipsis, within the field beside the icon.
  void longNamesInBoxesAreElided() {
    auto* recorder = new PaletteRecorder;
    const SharedPaletteStyle style(recorder);
    QStyleOptionComboBox option;
    option.currentText = "Environment, blurred";
    const int needed = option.fontMetrics.horizontalAdvance(option.currentText);
    const auto drawn = [&](int width) {
      option.rect = QRect(0, 0, width, 24);
      style.drawControl(QStyle::CE_ComboBoxLabel, &option, nullptr);
      return recorder->comboText;
    };
    QCOMPARE(drawn(2 * needed), option.currentText);
    const QString narrow = drawn(needed);
    const int room = style.subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, nullptr).width();
    QVERIFY(narrow.endsWith(QChar(0x2026)) && option.fontMetrics.horizontalAdvance(narrow) <= room);
    option.currentIcon = QIcon(QPixmap(16, 16));
    option.iconSize = {16, 16};
    QVERIFY(drawn(needed).size() < narrow.size());
  }

  /// The theme can be changed and changed back; choosing it again changes nothing.
  void themesChangeTheWidgets() {
    QPushButton button("text");
    button.setEnabled(false);
    const auto picture = [&](Theme theme) {
      applyTheme(*qApp, theme);
      return button.grab().toImage();
    };
    const QImage light = picture(Theme::light), dark = picture(Theme::dark);
    // Within the frame, beside the text.
    QVERIFY(light.pixelColor(5, light.height() / 2).lightness() > 160);
    QVERIFY(dark.pixelColor(5, dark.height() / 2).lightness() < 96);
    QCOMPARE(picture(Theme::light), light);
    const qint64 palette = button.palette().cacheKey();
    QCOMPARE(picture(Theme::light), light);
    QCOMPARE(button.palette().cacheKey(), palette);
    QCOMPARE(picture(Theme::dark), dark);
  }
};

GONIO_TEST(SharedPaletteStyleTest)
}  // namespace shared_palette_style_test

#include "shared_palette_style_test.moc"
