// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/sorted_table.h"

#include <QCoreApplication>
#include <QEvent>
#include <QLabel>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QTest>
#include <QTreeView>

#include "tests/support/test_program.h"

namespace sorted_table_test {
using namespace gonio;

class SortedTableTest : public QObject {
  Q_OBJECT

  static QStandardItem* item(int value) {
    auto* result = new QStandardItem(QString::number(value));
    result->setData(value, Qt::UserRole);
    return result;
  }

 private Q_SLOTS:
  void rowsStayUnderThePointer() {
    QStandardItemModel model;
    for (const int value : {3, 1, 2}) model.appendRow(item(value));
    QSortFilterProxyModel sorted;
    QTreeView view;
    QLabel empty(&view);
    widgets::setUpSortedTable(view, sorted, model, empty);
    view.sortByColumn(0, Qt::AscendingOrder);
    const auto values = [&] {
      QList<int> result;
      for (int row = 0; row < sorted.rowCount(); ++row) result << sorted.index(row, 0).data(Qt::UserRole).toInt();
      return result;
    };
    QCOMPARE(values(), QList<int>({1, 2, 3}));
    QEvent enter(QEvent::Enter), leave(QEvent::Leave);
    QCoreApplication::sendEvent(view.viewport(), &enter);
    model.item(1)->setData(9, Qt::UserRole);
    QCOMPARE(values(), QList<int>({9, 2, 3}));
    view.sortByColumn(0, Qt::DescendingOrder);  // by a click on the header
    QCOMPARE(values(), QList<int>({9, 3, 2}));
    model.item(1)->setData(1, Qt::UserRole);
    QCOMPARE(values(), QList<int>({1, 3, 2}));
    QCoreApplication::sendEvent(view.viewport(), &leave);
    QCOMPARE(values(), QList<int>({3, 2, 1}));
    model.item(1)->setData(5, Qt::UserRole);
    QCOMPARE(values(), QList<int>({5, 3, 2}));
  }
};

GONIO_TEST(SortedTableTest)
}  // namespace sorted_table_test

#include "sorted_table_test.moc"
