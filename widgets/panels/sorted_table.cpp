// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/sorted_table.h"

#include <QEvent>
#include <QLabel>
#include <QSortFilterProxyModel>
#include <QTreeView>
#include <QVBoxLayout>

namespace gonio::widgets {

namespace {

/// Rows keep their places while the pointer is over them: a value that comes then does not move another row under it.
class StillRows : public QObject {
 public:
  StillRows(QWidget& viewport, QSortFilterProxyModel& sorted) : QObject(&viewport), m_sorted(sorted) {
    viewport.installEventFilter(this);
  }

  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Enter || event->type() == QEvent::Leave)
      m_sorted.setDynamicSortFilter(event->type() == QEvent::Leave);
    return false;
  }

 private:
  QSortFilterProxyModel& m_sorted;
};

}  // namespace

void setUpSortedTable(QTreeView& view, QSortFilterProxyModel& sorted, QAbstractItemModel& source, QLabel& empty) {
  sorted.setSourceModel(&source);
  sorted.setSortRole(Qt::UserRole);
  sorted.setSortCaseSensitivity(Qt::CaseInsensitive);
  view.setModel(&sorted);
  view.setRootIsDecorated(false);
  view.setUniformRowHeights(true);
  view.setAllColumnsShowFocus(true);
  view.setSortingEnabled(true);
  new StillRows(*view.viewport(), sorted);
  empty.setAlignment(Qt::AlignCenter);
  empty.setWordWrap(true);
  empty.setForegroundRole(QPalette::PlaceholderText);
  empty.setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* over = new QVBoxLayout(view.viewport());
  over->addWidget(&empty);
}

}  // namespace gonio::widgets
