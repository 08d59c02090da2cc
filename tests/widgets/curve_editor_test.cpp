// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/curves/curve_editor.h"

#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "tests/support/test_program.h"
#include "tests/widgets/pointer.h"

namespace curve_editor_test {
using namespace gonio;
using widgets::ChannelCurves;
using widgets::CurveEditor;

std::vector<double> nodes() {
  std::vector<double> result;
  for (int i = 0; i <= 100; ++i) result.push_back(i / 50.0);
  return result;
}

/// Gaussians of equal width, red strongest.
ChannelCurves curves() {
  ChannelCurves result;
  for (int c = 0; c < 3; ++c)
    for (const double x : nodes()) result[std::size_t(c)].push_back((3 - c) * std::exp(-4 * x * x));
  return result;
}

class CurveEditorTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<CurveEditor> m_editor;

  QPoint at(std::size_t point) const { return m_editor->pointPosition(point).toPoint(); }

 private Q_SLOTS:
  void initTestCase() { qRegisterMetaType<ChannelCurves>(); }
  void init() {
    m_editor = std::make_unique<CurveEditor>();
    m_editor->resize(500, 320);
    m_editor->setAxis({.title = "F2", .label = "|Dp|", .valueLabel = "fraction", .tick = 0.5, .squareRoot = true});
    m_editor->setCurves(nodes(), curves(), curves());
    m_editor->show();
    m_editor->setFocus();
  }

  /// What was said of a point of other curves goes with them.
  void otherCurvesHaveNoReadout() {
    QTest::mouseClick(m_editor.get(), Qt::LeftButton, {}, at(1));
    QVERIFY(!m_editor->accessibleDescription().isEmpty());
    ChannelCurves others = curves();
    for (auto& curve : others)
      for (double& value : curve) value *= 0.5;
    m_editor->setCurves(nodes(), others, others);
    QVERIFY(m_editor->accessibleDescription().isEmpty());
  }

  /// The dragged point lies under the mouse, the channels keep their proportions, one interaction frames it.
  void aDragPullsTheLinkedCurves() {
    QSignalSpy started(m_editor.get(), &CurveEditor::interactionStarted);
    QSignalSpy ended(m_editor.get(), &CurveEditor::interactionEnded);
    QSignalSpy edited(m_editor.get(), &CurveEditor::curvesEdited);
    QVERIFY(m_editor->points().size() >= 4);
    const QPoint from = at(1), to = from + QPoint(0, -30);
    QTest::mousePress(m_editor.get(), Qt::LeftButton, {}, from);
    QTest::mouseMove(m_editor.get(), from + QPoint(0, -10));
    QTest::mouseMove(m_editor.get(), to);
    QVERIFY((m_editor->pointPosition(1) - QPointF(to)).manhattanLength() < 3);
    QTest::mouseRelease(m_editor.get(), Qt::LeftButton, {}, to);
    QCOMPARE(started.count(), 1);
    QCOMPARE(ended.count(), 1);
    QVERIFY(edited.count() >= 2);
    const ChannelCurves& now = m_editor->curves();
    for (std::size_t i = 0; i < nodes().size(); ++i) {
      QVERIFY(std::abs(now[0][i] - 1.5 * now[1][i]) < 1e-9);
      QVERIFY(std::abs(now[0][i] - 3 * now[2][i]) < 1e-9);
    }
    QVERIFY(now != curves());
    QVERIFY(std::abs(now[0][100] - curves()[0][100]) < 1e-9);
  }

  void oneChannelLeavesTheOthers() {
    m_editor->setChannel(1);
    const QPoint from = at(0);
    QTest::mousePress(m_editor.get(), Qt::LeftButton, {}, from);
    QTest::mouseMove(m_editor.get(), from + QPoint(0, 20));
    QTest::mouseRelease(m_editor.get(), Qt::LeftButton, {}, from + QPoint(0, 20));
    QVERIFY(m_editor->curves()[0] == curves()[0] && m_editor->curves()[2] == curves()[2]);
    QVERIFY(m_editor->curves()[1][0] < curves()[1][0]);
  }

  void pointsComeAndGo() {
    const std::size_t before = m_editor->points().size();
    const QPoint between = (at(1) + at(2)) / 2;
    QTest::mouseDClick(m_editor.get(), Qt::LeftButton, {}, QPoint(between.x(), 60));
    QCOMPARE(m_editor->points().size(), before + 1);
    QVERIFY(m_editor->curves() == curves());
    QTest::keyClick(m_editor.get(), Qt::Key_Delete);
    QCOMPARE(m_editor->points().size(), before);
    // The ends stay.
    QTest::keyClick(m_editor.get(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(m_editor.get(), Qt::Key_Delete);
    QCOMPARE(m_editor->points().size(), std::size_t(2));
  }

  void aBoxSelects() {
    const QPoint corner = at(1) + QPoint(-12, -12), other = at(2) + QPoint(12, 12);
    QTest::mousePress(m_editor.get(), Qt::LeftButton, {}, corner);
    QTest::mouseMove(m_editor.get(), other);
    QTest::mouseRelease(m_editor.get(), Qt::LeftButton, {}, other);
    QVERIFY(m_editor->selected()[1] && m_editor->selected()[2]);
    QVERIFY(!m_editor->selected()[0] && !m_editor->selected().back());
    QVERIFY(m_editor->curves() == curves());
  }

  /// Every point by the keyboard alone, each key a step, its value announced.
  void theKeyboardDoesItAll() {
    QSignalSpy ended(m_editor.get(), &CurveEditor::interactionEnded);
    QTest::mouseClick(m_editor.get(), Qt::LeftButton, {}, at(0));
    QCOMPARE(ended.count(), 1);
    QTest::keyClick(m_editor.get(), Qt::Key_Tab);
    QVERIFY(m_editor->selected()[1] && !m_editor->selected()[0]);
    QVERIFY(m_editor->accessibleDescription().startsWith("Point 2 of"));
    const QPointF before = m_editor->pointPosition(1);
    const QString reported = m_editor->accessibleDescription();
    QTest::keyClick(m_editor.get(), Qt::Key_Up, Qt::ShiftModifier);
    const double fine = before.y() - m_editor->pointPosition(1).y();
    QVERIFY(std::abs(fine - 1) < 0.2);
    QVERIFY(m_editor->accessibleDescription() != reported);
    QTest::keyClick(m_editor.get(), Qt::Key_Right);
    QVERIFY(std::abs(m_editor->pointPosition(1).x() - before.x() - 10) < 0.5);
    QCOMPARE(ended.count(), 3);
  }

  /// What the owner sends back after each step of a drag does not take the points out of the hand.
  void theOwnerMaySendTheCurvesBack() {
    connect(m_editor.get(), &CurveEditor::curvesEdited, m_editor.get(),
            [this](const ChannelCurves& now) { m_editor->setCurves(nodes(), now, curves()); });
    const QPoint from = at(1);
    const std::size_t count = m_editor->points().size();
    QTest::mousePress(m_editor.get(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 5; ++i) QTest::mouseMove(m_editor.get(), from + QPoint(3 * i, -4 * i));
    QTest::mouseRelease(m_editor.get(), Qt::LeftButton, {}, from + QPoint(15, -20));
    QCOMPARE(m_editor->points().size(), count);
    QVERIFY(m_editor->selected()[1]);
  }

  /// Escape while the mouse is down: the curves, the points and the owner's view of them as they were.
  void escapeTakesADragBack() {
    QSignalSpy ended(m_editor.get(), &CurveEditor::interactionEnded);
    QSignalSpy edited(m_editor.get(), &CurveEditor::curvesEdited);
    const QPoint from = at(1);
    const std::vector<double> points = m_editor->points();
    QTest::mousePress(m_editor.get(), Qt::LeftButton, {}, from);
    QTest::mouseMove(m_editor.get(), from + QPoint(20, -25));
    QVERIFY(m_editor->curves() != curves());
    QTest::keyClick(m_editor.get(), Qt::Key_Escape);
    QVERIFY(m_editor->curves() == curves());
    QVERIFY(m_editor->points() == points);
    QVERIFY(edited.last()[0].value<ChannelCurves>() == curves());
    QCOMPARE(ended.count(), 1);
    // The hand that still holds the button moves nothing more.
    QTest::mouseMove(m_editor.get(), from + QPoint(40, -50));
    QTest::mouseRelease(m_editor.get(), Qt::LeftButton, {}, from + QPoint(40, -50));
    QVERIFY(m_editor->curves() == curves());
    QCOMPARE(ended.count(), 1);
  }

  void aSecondBoxAddsWithShift() {
    const auto box = [this](std::size_t point, Qt::KeyboardModifiers modifiers) {
      const QPoint corner = at(point) + QPoint(-11, -11), other = at(point) + QPoint(11, 11);
      QTest::mousePress(m_editor.get(), Qt::LeftButton, modifiers, corner);
      QTest::mouseMove(m_editor.get(), other);
      QTest::mouseRelease(m_editor.get(), Qt::LeftButton, modifiers, other);
    };
    const std::size_t last = m_editor->points().size() - 1;
    box(1, {});
    box(last, Qt::ShiftModifier);
    QVERIFY(m_editor->selected()[1] && m_editor->selected()[last]);
    box(last, {});
    QVERIFY(!m_editor->selected()[1] && m_editor->selected()[last]);
  }

  /// The readout shows the position of the pointer, the line under the chart its values.
  void tellsWhereThePointerIs() {
    QSignalSpy pointed(m_editor.get(), &CurveEditor::pointedAt);
    const QPoint over(at(2).x(), 60);
    test::pointAt(*m_editor, over);
    QVERIFY(!pointed.isEmpty());
    QVERIFY(std::abs(pointed.last()[0].toDouble() - m_editor->points()[2]) < 0.02);
    pointed.clear();
    QTest::mouseClick(m_editor.get(), Qt::LeftButton, {}, at(1));
    QCOMPARE(pointed.first()[0].toDouble(), m_editor->points()[1]);
    m_editor->setLimits({{0.5, "here"}}, 1.5);
    QCOMPARE(m_editor->limits().size(), std::size_t(1));
  }

  void nothingToShowIsNothingToDo() {
    m_editor->clear();
    m_editor->setHint("Nothing");
    QTest::mouseClick(m_editor.get(), Qt::LeftButton, {}, QPoint(100, 100));
    QTest::mouseDClick(m_editor.get(), Qt::LeftButton, {}, QPoint(100, 100));
    QTest::keyClick(m_editor.get(), Qt::Key_Up);
    QVERIFY(m_editor->points().empty());
    // Nothing is left of the curves: it looks like one that never had any.
    CurveEditor other;
    other.setAxis(m_editor->axis());
    other.resize(m_editor->size());
    other.setHint("Nothing");
    m_editor->clearFocus();
    QVERIFY(m_editor->grab().toImage() == other.grab().toImage());
  }
};

GONIO_TEST(CurveEditorTest)
}  // namespace curve_editor_test

#include "curve_editor_test.moc"
