// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/edit_stack.h"

#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "tests/support/test_program.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"

namespace edit_stack_test {
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

  QListWidget* list() const { return m_stack->findChild<QListWidget*>(); }

 private Q_SLOTS:
  void init() {
    m_stack = std::make_unique<EditStack>();
    m_stack->resize(400, 200);
    m_stack->setEntries({{"Factor curves", "", 0.5, true}, {"GGX", "", 1, false}}, 0, "None");
    m_stack->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_stack.get()));
  }

  void showsWhatItIsTold() {
    QCOMPARE(named<NumberField>("Strength of Factor curves")->text(), QStringLiteral("50\u202F%"));
    QVERIFY(named<QToolButton>("Factor curves enabled")->isChecked());
    QVERIFY(!named<QToolButton>("GGX enabled")->isChecked());
    QVERIFY(!named<ParameterSlider>("Strength of GGX")->isEnabled());  // what is hidden has no strength to pull
    m_stack->setEntries({}, -1, "None");
    const auto* empty = m_stack->findChild<QLabel*>(QString(), Qt::FindDirectChildrenOnly);
    QCOMPARE(empty->text(), QStringLiteral("None"));
    QVERIFY(empty->isVisible() && !list()->isVisible());
    // The first edit takes its place: what stands below does not move while a slider is dragged.
    const QSize before = m_stack->sizeHint();
    m_stack->setEntries({{.name = "GGX", .effect = "Albedo: measuring..."}}, 0, {});
    QCOMPARE(m_stack->sizeHint().height(), before.height());
  }

  /// A list that becomes narrower, as beside a scroll bar, cuts off no row.
  void rowsFollowTheWidth() {
    QToolButton* last = named<QToolButton>("Delete GGX");
    const auto rightEdge = [&] { return last->mapTo(list()->viewport(), last->rect().topRight()).x(); };
    QTRY_VERIFY(rightEdge() > 300 && rightEdge() < list()->viewport()->width());
    m_stack->resize(280, 200);
    QTRY_VERIFY(list()->viewport()->width() <= 280 && rightEdge() < list()->viewport()->width());
  }

  /// By keyboard: the eye, the strength, the deletion of each entry; nothing is shown before it is reported back.
  void tellsWhatIsWanted() {
    QSignalSpy enabled(m_stack.get(), &EditStack::enabledChosen);
    QSignalSpy strength(m_stack.get(), &EditStack::strengthEdited);
    QSignalSpy removed(m_stack.get(), &EditStack::deleteRequested);
    QTest::keyClick(named<QToolButton>("GGX enabled"), Qt::Key_Space);
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

  /// By keyboard: the order, a copy, the deletion; at the ends there is nowhere to go.
  void keysActOnTheSelectedEntry() {
    QSignalSpy moved(m_stack.get(), &EditStack::moveRequested);
    QSignalSpy removed(m_stack.get(), &EditStack::deleteRequested);
    QSignalSpy chosen(m_stack.get(), &EditStack::selectionChosen);
    QSignalSpy copied(m_stack.get(), &EditStack::duplicateRequested);
    list()->setFocus();
    QTest::keyClick(list(), Qt::Key_Up, Qt::AltModifier);
    QCOMPARE(moved.count(), 0);
    QTest::keyClick(list(), Qt::Key_Down, Qt::AltModifier);
    QCOMPARE(moved.count(), 1);
    QCOMPARE(moved[0], (QVariantList{0, 1}));
    QTest::keyClick(list(), Qt::Key_Down);
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(m_stack->selected(), 1);
    QTest::keyClick(list(), Qt::Key_Up, Qt::AltModifier);
    QCOMPARE(moved[1], (QVariantList{1, 0}));
    QTest::keyClick(list(), Qt::Key_Delete);
    QCOMPARE(removed[0][0].toInt(), 1);
    for (QToolButton* button : m_stack->findChildren<QToolButton*>())
      if (button->text() == "Duplicate") button->click();
    QCOMPARE(copied[0][0].toInt(), 1);
  }

  /// A row that is dropped asks for a move: above the middle of another row before it, else behind it.
  void aDropAsksForAMove() {
    m_stack->setEntries({{"a"}, {"b"}, {"c"}}, 0, "None");
    QSignalSpy moved(m_stack.get(), &EditStack::moveRequested);
    const auto drop = [this](int from, int over, double fraction) {
      list()->setCurrentRow(from);
      const QRect row = list()->visualItemRect(list()->item(over));
      const QPointF place(row.center().x(), row.top() + fraction * row.height());
      const std::unique_ptr<QMimeData> data(list()->model()->mimeData({list()->currentIndex()}));
      QDropEvent event(place, Qt::MoveAction, data.get(), Qt::LeftButton, {});
      // Without a drag under way QApplication delivers no drop.
      struct Access : QListWidget {
        using QListWidget::dropEvent;
      };
      (list()->*&Access::dropEvent)(&event);
      QCoreApplication::processEvents();
    };
    drop(0, 2, 0.8);
    QCOMPARE(moved.count(), 1);
    QCOMPARE(moved[0], (QVariantList{0, 2}));
    drop(0, 1, 0.2);  // where it is
    QCOMPARE(moved.count(), 1);
    drop(2, 0, 0.2);
    QCOMPARE(moved[1], (QVariantList{2, 0}));
    drop(0, 1, 0.8);
    QCOMPARE(moved[2], (QVariantList{0, 1}));
    QCOMPARE(list()->count(), 3);  // the owner moves rows
  }

  /// F2 or a double click: Return takes the name, Escape leaves it; what the user named starts with its own name.
  void anEntryIsRenamed() {
    m_stack->setEntries({{"GGX"}, {"Wetter 2", "", 1, true, "Wetter"}}, 1, "None");
    QCoreApplication::processEvents();  // the rows appear
    QSignalSpy renamed(m_stack.get(), &EditStack::renamed);
    const auto field = [this] {
      for (QLineEdit* one : m_stack->findChildren<QLineEdit*>())
        if (one->accessibleName() == "Name of the edit" && one->isVisible()) return one;
      return static_cast<QLineEdit*>(nullptr);
    };
    list()->setFocus();
    QTest::keyClick(list(), Qt::Key_F2);
    QVERIFY(field());
    QCOMPARE(field()->text(), QStringLiteral("Wetter"));
    QTest::keyClicks(field(), "Dry");
    QTest::keyClick(field(), Qt::Key_Escape);
    QVERIFY(!field());
    QCOMPARE(renamed.count(), 0);
    m_stack->beginRename(0);
    QVERIFY(field()->text().isEmpty());
    QTest::keyClicks(field(), "Base coat");
    QTest::keyClick(field(), Qt::Key_Return);
    QCOMPARE(renamed.count(), 1);
    QCOMPARE(renamed[0], (QVariantList{0, "Base coat"}));
    const QPoint name = list()->visualItemRect(list()->item(1)).center();
    QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, name);
    QTest::mouseDClick(list()->viewport(), Qt::LeftButton, {}, name);
    QVERIFY(field());
  }

  /// One drag lies between start and end, and what comes back meanwhile leaves the slider in the hand.
  void aDragIsOneInteraction() {
    connect(m_stack.get(), &EditStack::strengthEdited, m_stack.get(), [this](int, double to) {
      m_stack->setEntries({{"Factor curves", "", to, true}, {"GGX", "", 1, false}}, 0, "None");
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
}  // namespace edit_stack_test

#include "edit_stack_test.moc"
