// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/library_order.h"

namespace gonio::widgets {

LibraryOrder::LibraryOrder(LibraryModel* model, QObject* parent) : QSortFilterProxyModel(parent), m_model(model) {
  setSourceModel(model);
  setFilterCaseSensitivity(Qt::CaseInsensitive);
  setSortCaseSensitivity(Qt::CaseInsensitive);
}

void LibraryOrder::setGrouping(LibraryGrouping grouping) {
  m_grouping = grouping;
  invalidate();
}

bool LibraryOrder::matches(int row) const {
  const QRegularExpression search = filterRegularExpression();
  return m_model->index(row).data().toString().contains(search) ||
         m_model->group(row, LibraryGrouping::kind).contains(search);
}

bool LibraryOrder::filterAcceptsRow(int row, const QModelIndex&) const {
  const LibraryGrouping heading = m_model->headingOf(row);
  if (heading == LibraryGrouping::none) return matches(row);
  if (heading != m_grouping) return false;
  const QString title = m_model->group(row, heading);
  for (int other = 0; other < m_model->rowCount(); ++other)
    if (m_model->headingOf(other) == LibraryGrouping::none && m_model->group(other, heading) == title && matches(other))
      return true;
  return false;
}

bool LibraryOrder::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const int leftRank = m_model->groupRank(left.row(), m_grouping),
            rightRank = m_model->groupRank(right.row(), m_grouping);
  if (leftRank != rightRank) return leftRank < rightRank;
  const bool leftHeading = m_model->headingOf(left.row()) != LibraryGrouping::none;
  const bool rightHeading = m_model->headingOf(right.row()) != LibraryGrouping::none;
  if (leftHeading != rightHeading) return leftHeading;
  return QSortFilterProxyModel::lessThan(left, right);
}

}  // namespace gonio::widgets

#include "moc_library_order.cpp"
