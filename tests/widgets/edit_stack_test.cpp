// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/edit_stack.h"

#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "tests/support/test_program.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"

using namespace gonio::widgets;

class EditStackTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<EditStack> m_stack;

  template <class Widget>
  Widget* named(const QString& name) const {
    for (Widget* one : m_stack->findChildren<Widget*>())
      if (one->accessibleName() == name && !one->isHidden()) return one;
    return nullptr;
  }

 private Q_SLOTS:
  void init() {
    m_stack = std::make_unique<EditStack>();
    m_stack->resize(400, 200);
    m_stack->setEntries({{"Factor curves", "", 0.5, true}, {"GGX", "", 1, false}}, "None");
    m_stack->show();
  }

  void showsWhatItIsTold() {
    QCOMPARE(named<NumberField>("Strength of Factor curves")->text(), QStringLiteral("50\u202F%"));
    QVERIFY(named<QToolButton>("Factor curves is shown")->isChecked());
    QVERIFY(!named<QToolButton>("GGX is shown")->isChecked());
    QVERIFY(!named<ParameterSlider>("Strength of GGX")->isEnabled());  // what is hidden has no strength to pull
    m_stack->setEntries({}, "None");
    QCOMPARE(m_stack->findChild<QLabel*>()->text(), QStringLiteral("None"));
    QVERIFY(m_stack->findChild<QLabel*>()->isVisible());
  }

  /// By keyboard: the eye, the strength, the deletion of each entry; nothing is shown before it is told back.
  void tellsWhatIsWanted() {
    QSignalSpy enabled(m_stack.get(), &EditStack::enabledChosen);
    QSignalSpy strength(m_stack.get(), &EditStack::strengthEdited);
    QSignalSpy removed(m_stack.get(), &EditStack::deleteRequested);
    QTest::keyClick(named<QToolButton>("GGX is shown"), Qt::Key_Space);
    QCOMPARE(enabled.count(), 1);
    QCOMPARE(enabled[0][0].toInt(), 1);
    QVERIFY(enabled[0][1].toBool());
    auto* field = named<NumberField>("Strength of Factor curves");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "30");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(strength.count(), 1);
    QCOMPARE(strength[0][0].toInt(), 0);
    QVERIFY(qAbs(strength[0][1].toDouble() - 0.3) < 1e-12);
    QCOMPARE(m_stack->entries()[0].strength, 0.5);
    QTest::keyClick(named<QToolButton>("Delete GGX"), Qt::Key_Space);
    QCOMPARE(removed.count(), 1);
    QCOMPARE(removed[0][0].toInt(), 1);
  }

  /// One drag lies between start and end, and what comes back meanwhile leaves the slider in the hand.
  void aDragIsOneInteraction() {
    connect(m_stack.get(), &EditStack::strengthEdited, m_stack.get(), [this](int, double to) {
      m_stack->setEntries({{"Factor curves", "", to, true}, {"GGX", "", 1, false}}, "None");
    });
    QSignalSpy started(m_stack.get(), &EditStack::editingStarted);
    QSignalSpy finished(m_stack.get(), &EditStack::editingFinished);
    auto* slider = named<ParameterSlider>("Strength of Factor curves");
    const QPoint middle = slider->rect().center();
    QTest::mousePress(slider, Qt::LeftButton, {}, middle);
    QTest::mouseMove(slider, middle + QPoint(10, 0));
    QTest::mouseMove(slider, middle + QPoint(30, 0));
    QCOMPARE(named<ParameterSlider>("Strength of Factor curves"), slider);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, middle + QPoint(30, 0));
    QCOMPARE(started.count(), 1);
    QCOMPARE(finished.count(), 1);
    QVERIFY(m_stack->entries()[0].strength > 0.55);
  }
};

GONIO_TEST(EditStackTest)
#include "edit_stack_test.moc"
