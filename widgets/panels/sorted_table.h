// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

class QAbstractItemModel;
class QLabel;
class QSortFilterProxyModel;
class QTreeView;

namespace gonio::widgets {

/// Sets up a table view that is sorted by its headers, by the model's values in Qt::UserRole. When values change, rows
/// are sorted again unless the pointer is over them. `empty` is laid over the table; the caller shows it with
/// instructions while there are no rows.
void setUpSortedTable(QTreeView& view, QSortFilterProxyModel& sorted, QAbstractItemModel& source, QLabel& empty);

}  // namespace gonio::widgets
