// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/colour_picker.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "tests/support/test_program.h"
#include "widgets/inputs/number_field.h"

namespace colour_picker_test {
using namespace gonio::widgets;

/// Whether two colours are equal in 8 bits.
bool isSame(const QColor& a, const QColor& b) { return a.rgb() == b.rgb(); }

class ColourPickerTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Every colour that is set is the colour of the dialog, and its digits.
  void returnsWhatItWasGiven() {
    for (const QColor& colour : {QColor(255, 0, 0), QColor(12, 200, 99), QColor(70, 70, 70), QColor(0, 0, 0)}) {
      ColourPicker picker(colour, nullptr);
      QVERIFY(isSame(picker.colour(), colour));
      QCOMPARE(picker.digits().text(), colour.name());
    }
  }

  /// A press on the wheel, against HSV by hand: the right edge is red, the top is at 90 degrees, the centre is grey.
  void theWheelHasHueAndSaturation() {
    ColourPicker picker(QColor(255, 255, 255), nullptr);
    picker.show();
    QSignalSpy changed(&picker, &ColourPicker::colourChanged);
    ColourWheel& wheel = picker.wheel();
    const QPoint centre = wheel.rect().center();
    const auto press = [&](const QPoint& place) {
      QTest::mouseClick(&wheel, Qt::LeftButton, {}, place);
      return picker.colour();
    };
    QVERIFY(isSame(press({wheel.width() - 1, centre.y()}), QColor(255, 0, 0)) ||
            picker.colour().hsvSaturationF() > 0.98);
    QVERIFY(std::abs(press({centre.x(), 1}).hsvHueF() - 0.25) < 0.01);
    QVERIFY(press(centre).hsvSaturationF() < 0.02);
    QCOMPARE(changed.count(), 3);
  }

  /// Hue and saturation survive a value of 0, from which no colour could tell them.
  void blackKeepsTheHue() {
    const QColor blue(20, 40, 220);
    ColourPicker picker(blue, nullptr);
    const auto type = [&](const char* text) {
      picker.field(2).setFocus();
      picker.field(2).setText(text);
      QTest::keyClick(&picker.field(2), Qt::Key_Return);
    };
    picker.show();
    const double value = blue.valueF();
    type("0");
    QVERIFY(isSame(picker.colour(), QColor(0, 0, 0)));
    type(qPrintable(QString::number(100 * value)));
    QVERIFY(isSame(picker.colour(), blue));
  }

  void digitsAreRead() {
    ColourPicker picker(QColor(0, 0, 0), nullptr);
    picker.show();
    picker.digits().setFocus();
    picker.digits().selectAll();
    QTest::keyClicks(&picker.digits(), "#3366CC");
    QVERIFY(isSame(picker.colour(), QColor(0x33, 0x66, 0xcc)));
    QTest::keyClicks(&picker.digits(), "9");  // no colour: nothing changes
    QVERIFY(isSame(picker.colour(), QColor(0x33, 0x66, 0xcc)));
  }
};

GONIO_TEST(ColourPickerTest)
}  // namespace colour_picker_test

#include "colour_picker_test.moc"
