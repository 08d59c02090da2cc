// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/figures/entry_list.h"

#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "tests/support/test_program.h"

namespace entry_list_test {
using namespace gonio::widgets;

class EntryListTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<EntryList> m_list;

  QToolButton* button(const QString& text) const {
    for (QToolButton* one : m_list->findChildren<QToolButton*>())
      if (one->text() == text) return one;
    return nullptr;
  }
  QVariant data(int row, int column, int role = Qt::DisplayRole) const {
    return m_list->model().data(m_list->model().index(row, column), role);
  }
  bool set(int row, int column, const QVariant& value) const {
    return m_list->model().setData(m_list->model().index(row, column), value, Qt::EditRole);
  }

 private Q_SLOTS:
  void init() {
    m_list = std::make_unique<EntryList>("Representation", true);
    m_list->setEntries({{.name = "GGX", .usualLabel = "GGX"},
                        {.name = "PDV", .label = "ours", .usualLabel = "PDV, 10 terms", .budget = 10, .maxBudget = 20},
                        {.name = "Code", .usualLabel = "Code, 64", .budget = 64, .maxBudget = 65535}},
                       false);
    m_list->show();
  }

  /// Without a label of the user, the default label is shown in grey; it is not the text to edit.
  void labels() {
    QCOMPARE(data(0, 2).toString(), QString("GGX"));
    QVERIFY(data(0, 2, Qt::EditRole).toString().isEmpty());
    QVERIFY(data(0, 2, Qt::ForegroundRole).isValid() && !data(1, 2, Qt::ForegroundRole).isValid());
    QCOMPARE(data(1, 2).toString(), QString("ours"));
    QSignalSpy edited(&m_list->model(), &EntryListModel::labelEdited);
    QVERIFY(set(0, 2, " mirror "));
    QCOMPARE(edited.takeFirst(), QVariantList({0, "mirror"}));
    QVERIFY(set(1, 2, "ours"));
    QVERIFY(edited.isEmpty());
    QVERIFY(!set(0, 0, "name"));
  }

  void budgetsStayInTheirRange() {
    QVERIFY(!data(0, 1).isValid());
    QCOMPARE(data(1, 1).toInt(), 10);
    QSignalSpy edited(&m_list->model(), &EntryListModel::budgetEdited);
    QVERIFY(!set(0, 1, 3) && !set(1, 1, 0) && !set(1, 1, 21));
    QVERIFY(set(1, 1, 10));
    QVERIFY(edited.isEmpty());
    QVERIFY(set(1, 1, 20));
    QCOMPARE(edited.takeFirst(), QVariantList({1, 20}));
  }

  /// Delete, Alt+Up, Alt+Down and F2 have the effect of the buttons and of a double-click.
  void keys() {
    QSignalSpy removed(m_list.get(), &EntryList::removeRequested), moved(m_list.get(), &EntryList::moveRequested);
    m_list->select(1);
    QTest::keyClick(&m_list->view(), Qt::Key_Delete);
    QCOMPARE(removed.takeFirst()[0].toInt(), 1);
    QTest::keyClick(&m_list->view(), Qt::Key_Up, Qt::AltModifier);
    QCOMPARE(moved.takeFirst(), QVariantList({1, 0}));
    QCOMPARE(m_list->current(), 0);
    QTest::keyClick(&m_list->view(), Qt::Key_Up, Qt::AltModifier);
    QVERIFY(moved.isEmpty());
    QTest::keyClick(&m_list->view(), Qt::Key_Down, Qt::AltModifier);
    QCOMPARE(moved.takeFirst(), QVariantList({0, 1}));
    QSignalSpy edited(&m_list->model(), &EntryListModel::labelEdited);
    m_list->view().setFocus();
    QTest::keyClick(&m_list->view(), Qt::Key_F2);
    auto* field = m_list->view().findChild<QLineEdit*>();
    QVERIFY(field && field->text() == "ours");
    field->selectAll();
    QTest::keyClicks(field, "theirs");
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_COMPARE(edited.count(), 1);  // the editor commits after the key event
    QCOMPARE(edited.takeFirst(), QVariantList({1, "theirs"}));
  }

  void buttonsAreThoseThatDoSomething() {
    const auto enabled = [&] {
      QString names;
      for (const char* name : {"Add", "Remove", "Move up", "Move down"})
        if (button(name)->isEnabled()) names += QString(name).section(' ', -1).front().toUpper();
      return names;
    };
    m_list->view().setCurrentIndex({});
    QCOMPARE(enabled(), QString("A"));
    m_list->select(0);
    QCOMPARE(enabled(), QString("ARD"));
    m_list->select(2);
    QCOMPARE(enabled(), QString("ARU"));
    QSignalSpy moved(m_list.get(), &EntryList::moveRequested), removed(m_list.get(), &EntryList::removeRequested);
    button("Move up")->click();
    button("Remove")->click();
    QCOMPARE(moved.count() + removed.count(), 2);
    m_list->setEntries({{.name = "GGX"}}, true);
    QVERIFY(!button("Add")->isEnabled());
  }

  /// The selection remains when entries change; the text for an empty list is shown only while the list is empty.
  void emptyList() {
    m_list->setEmptyText("Add representations");
    const auto isShown = [&] {
      for (const QLabel* label : m_list->findChildren<QLabel*>())
        if (label->text() == "Add representations") return label->isVisible();
      return false;
    };
    QVERIFY(!isShown());
    m_list->setEntries({}, false);
    QVERIFY(isShown() && m_list->current() < 0 && !button("Remove")->isEnabled());
    m_list->setEntries({{.name = "a"}, {.name = "b"}}, false);
    m_list->select(1);
    m_list->setEntries({{.name = "a"}, {.name = "b"}, {.name = "c"}}, false);
    QCOMPARE(m_list->current(), 1);
    QVERIFY(!isShown());
  }
};

GONIO_TEST(EntryListTest)
}  // namespace entry_list_test

#include "entry_list_test.moc"
