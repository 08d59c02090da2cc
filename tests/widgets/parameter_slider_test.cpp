// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/parameter_slider.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/support/test_program.h"

namespace parameter_slider_test {
using gonio::models::ParameterScale;
using gonio::widgets::ParameterSlider;

class ParameterSliderTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void keysMoveOnTheScale() {
    ParameterSlider slider;
    slider.setRange(0.01, 1, ParameterScale::logarithmic);
    slider.setNumber(0.1);
    QTest::keyClick(&slider, Qt::Key_PageUp);
    QVERIFY(qAbs(slider.number() - 0.1 * std::pow(100, 0.1)) < 1e-12);
    QTest::keyClick(&slider, Qt::Key_End);
    QVERIFY(slider.number() == 1);
    QTest::keyClick(&slider, Qt::Key_Home);
    QVERIFY(slider.number() == 0.01);
    slider.setRange(0, 2, ParameterScale::linear);
    slider.setNumber(1);
    QTest::keyClick(&slider, Qt::Key_Right, Qt::ShiftModifier);
    QVERIFY(qAbs(slider.number() - 1.002) < 1e-12);
  }

  /// Press, three moves, release: one pair of started and finished around the edits.
  void aDragIsBracketed() {
    ParameterSlider slider;
    slider.resize(200, 24);
    slider.show();
    QStringList order;
    connect(&slider, &ParameterSlider::editingStarted, this, [&] { order << "start"; });
    connect(&slider, &ParameterSlider::numberEdited, this, [&] { order << "edit"; });
    connect(&slider, &ParameterSlider::editingFinished, this, [&] { order << "end"; });
    QTest::mousePress(&slider, Qt::LeftButton, {}, {60, 12});
    for (const int x : {80, 100, 120}) QTest::mouseMove(&slider, {x, 12});
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, {120, 12});
    QVERIFY(order.size() >= 4);
    QCOMPARE(order.first(), QStringLiteral("start"));
    QCOMPARE(order.last(), QStringLiteral("end"));
    QCOMPARE(order.count("start"), 1);
    QCOMPARE(order.count("end"), 1);
  }

  /// A drag that comes back to the reference reaches it exactly: a value that reads the same would be marked as
  /// changed.
  void aDragReachesTheReference() {
    ParameterSlider slider;
    slider.setRange(0.125, 8, ParameterScale::logarithmic);
    slider.resize(233, 24);
    slider.setReference(1.1);
    slider.setNumber(1.1);
    slider.show();
    const auto x = [&](int step) { return QPoint(120 + step, 12); };
    // Along the slider, one pixel after the other: one of them is the reference.
    QTest::mousePress(&slider, Qt::LeftButton, {}, {30, 12});
    int reached = 0;
    for (int step = -20; step <= 40; ++step) {
      QTest::mouseMove(&slider, x(step));
      reached += slider.number() == 1.1;
    }
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, x(40));
    QCOMPARE(reached, 1);
  }

  void shiftDragIsFineAndControlSnaps() {
    ParameterSlider slider;
    slider.resize(220, 24);
    slider.setNumber(0.5);
    slider.show();
    const auto move = [&](double x, Qt::KeyboardModifiers modifiers) {
      QMouseEvent event(QEvent::MouseMove, QPointF(x, 12), slider.mapToGlobal(QPointF(x, 12)), Qt::NoButton,
                        Qt::LeftButton, modifiers);
      QApplication::sendEvent(&slider, &event);
    };
    QTest::mousePress(&slider, Qt::LeftButton, Qt::ShiftModifier, {20, 12});
    QVERIFY(slider.number() == 0.5);  // no jump
    move(60, Qt::ShiftModifier);
    const double fine = slider.number() - 0.5;
    move(100, {});
    const double coarse = slider.number() - 0.5 - fine;
    QVERIFY(fine > 0);
    QVERIFY(qAbs(coarse / fine - 10) < 1e-9);
    move(104, Qt::ControlModifier);
    QVERIFY(qAbs(slider.number() * 20 - std::round(slider.number() * 20)) < 1e-12);
    QTest::mouseRelease(&slider, Qt::LeftButton);
  }

  void backspaceAndDoubleClickAskForReset() {
    ParameterSlider slider;
    QSignalSpy reset(&slider, &ParameterSlider::resetRequested);
    QTest::keyClick(&slider, Qt::Key_Backspace);
    QTest::mouseDClick(&slider, Qt::LeftButton);
    QCOMPARE(reset.count(), 2);
  }

  /// A scroll area full of sliders must scroll, not edit.
  void wheelNeedsTheFocus() {
    ParameterSlider slider;
    slider.setNumber(0.5);
    QWheelEvent event({2, 2}, {2, 2}, {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&slider, &event);
    QVERIFY(slider.number() == 0.5);
    QVERIFY(!event.isAccepted());
  }

  void aValueOutsideTheSoftRangeStaysWhatItIs() {
    ParameterSlider slider;
    slider.setRange(0, 1, ParameterScale::linear);
    slider.setNumber(7);
    QVERIFY(slider.number() == 7);
  }
};

GONIO_TEST(ParameterSliderTest)
}  // namespace parameter_slider_test

#include "parameter_slider_test.moc"
