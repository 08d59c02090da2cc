// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/sorted_table.h"

#include <QLabel>
#include <QSortFilterProxyModel>
#include <QTreeView>
#include <QVBoxLayout>

namespace gonio::widgets {

void setUpSortedTable(QTreeView& view, QSortFilterProxyModel& sorted, QAbstractItemModel& source, QLabel& empty) {
  sorted.setSourceModel(&source);
  sorted.setSortRole(Qt::UserRole);
  sorted.setSortCaseSensitivity(Qt::CaseInsensitive);
  view.setModel(&sorted);
  view.setRootIsDecorated(false);
  view.setUniformRowHeights(true);
  view.setAllColumnsShowFocus(true);
  view.setSortingEnabled(true);
  empty.setAlignment(Qt::AlignCenter);
  empty.setWordWrap(true);
  empty.setForegroundRole(QPalette::PlaceholderText);
  empty.setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* over = new QVBoxLayout(view.viewport());
  over->addWidget(&empty);
}

}  // namespace gonio::widgets
