// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

class QAbstractItemModel;
class QLabel;
class QSortFilterProxyModel;
class QTreeView;

namespace gonio::widgets {

/// Makes of a view a table that its headers sort, by the model's values in Qt::UserRole. Rows move to their places when
/// values change, but not while the pointer is over them. `empty` lies over it: the caller shows it with what to do
/// while there are no rows.
void setUpSortedTable(QTreeView& view, QSortFilterProxyModel& sorted, QAbstractItemModel& source, QLabel& empty);

}  // namespace gonio::widgets
