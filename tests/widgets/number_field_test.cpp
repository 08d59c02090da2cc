// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/number_field.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/support/test_program.h"

namespace number_field_test {
using gonio::widgets::NumberField;

class NumberFieldTest : public QObject {
  Q_OBJECT
 private:
  static void type(NumberField& field, const QString& text) {
    field.selectAll();
    QTest::keyClicks(&field, text);
  }

 private Q_SLOTS:
  void enterCommitsArithmetic() {
    NumberField field;
    field.setRange(0, 10);
    QSignalSpy edited(&field, &NumberField::valueEdited);
    type(field, "0.3*2");
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(edited.count(), 1);
    QCOMPARE(field.value(), 0.6);
    QCOMPARE(field.text(), QStringLiteral("0.6"));
  }

  void escapeRestores() {
    NumberField field;
    field.setValue(0.25);
    QSignalSpy edited(&field, &NumberField::valueEdited);
    type(field, "0.7");
    QTest::keyClick(&field, Qt::Key_Escape);
    QCOMPARE(field.text(), QStringLiteral("0.25"));
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(edited.count(), 0);
    QCOMPARE(field.value(), 0.25);
  }

  /// A letter where a number begins is left to the window as a shortcut; the letters of a unit are typed.
  void lettersBeginNoNumber() {
    NumberField field;
    field.setValue(2);
    field.selectAll();
    QKeyEvent asked(QEvent::ShortcutOverride, Qt::Key_C, Qt::NoModifier, QStringLiteral("c"));
    asked.ignore();
    QApplication::sendEvent(&field, &asked);
    QVERIFY(!asked.isAccepted());
    QTest::keyClicks(&field, QStringLiteral("c"));
    QCOMPARE(field.text(), QStringLiteral("2"));
    QTest::keyClicks(&field, QStringLiteral("3c"));
    QCOMPARE(field.text(), QStringLiteral("3c"));
    // Also after the program has changed the number, as undo does.
    field.show();
    field.activateWindow();
    field.setFocus();
    QTRY_VERIFY(field.hasFocus());
    field.setValue(4);
    QTest::keyClicks(&field, QStringLiteral("c"));
    QCOMPARE(field.text(), QStringLiteral("4"));
    type(field, "pi");
    QCOMPARE(field.text(), QStringLiteral("pi"));
  }

  void nonsenseRestores() {
    NumberField field;
    field.setValue(0.25);
    type(field, "4rough");
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(field.value(), 0.25);
    QCOMPARE(field.text(), QStringLiteral("0.25"));
  }

  /// The field shows four digits and holds all: committing what was not typed changes no bit.
  void unchangedTextKeepsEveryBit() {
    NumberField field;
    const double value = 0.12345678901234567;
    field.setValue(value);
    QSignalSpy edited(&field, &NumberField::valueEdited);
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(edited.count(), 0);
    QVERIFY(field.value() == value);
  }

  void outsideTheHardRangeIsClampedAndTold() {
    NumberField field;
    field.setRange(0, 1);
    QSignalSpy clamped(&field, &NumberField::clamped);
    type(field, "7");
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(field.value(), 1.0);
    QCOMPARE(clamped.count(), 1);
    QCOMPARE(clamped[0][0].toDouble(), 7.0);
  }

  void anglesAreShownInDegrees() {
    NumberField field;
    field.setRange(0, 3);
    field.setUnit(QStringLiteral("deg"), 180 / 3.14159265358979323846);
    type(field, "90");
    QTest::keyClick(&field, Qt::Key_Return);
    QVERIFY(qAbs(field.value() - 1.5707963267948966) < 1e-15);
  }

  void wheelNeedsTheFocus() {
    QWidget window;
    NumberField field(&window), other(&window);
    field.setValue(0.5);
    window.show();
    other.setFocus();
    const auto turn = [&] {
      QWheelEvent event({2, 2}, field.mapToGlobal(QPointF(2, 2)), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(&field, &event);
    };
    turn();
    QCOMPARE(field.value(), 0.5);
    window.activateWindow();
    field.setFocus();
    QTRY_VERIFY(field.hasFocus());
    turn();
    QCOMPARE(field.value(), 0.51);
  }

  void arrowsStep() {
    NumberField field;
    field.setValue(0.5);
    QTest::keyClick(&field, Qt::Key_Up);
    QCOMPARE(field.value(), 0.51);
    QTest::keyClick(&field, Qt::Key_Down, Qt::ShiftModifier);
    QCOMPARE(field.value(), 0.509);
  }
};

GONIO_TEST(NumberFieldTest)
}  // namespace number_field_test

#include "number_field_test.moc"
