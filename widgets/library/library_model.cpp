// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/library_model.h"

#include <algorithm>

#include "widgets/library/material_drag.h"

namespace gonio::widgets {

void LibraryModel::setItems(std::vector<LibraryItem> items) {
  beginResetModel();
  m_entries.clear();
  for (LibraryItem& item : items) m_entries.push_back({std::move(item), {}, {}, {}});
  endResetModel();
}

int LibraryModel::find(const QString& id) const {
  const auto found = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& e) { return e.item.id == id; });
  return found == m_entries.end() ? -1 : int(found - m_entries.begin());
}

void LibraryModel::setLook(const QString& id, const LibraryLook& look) {
  const int row = find(id);
  if (row < 0) return;
  Entry& entry = m_entries[std::size_t(row)];
  entry.look = look;
  entry.pixmap = QPixmap::fromImage(look.thumbnail);
  Q_EMIT dataChanged(index(row), index(row));
}

void LibraryModel::setFailure(const QString& id, const QString& reason) {
  const int row = find(id);
  if (row < 0) return;
  m_entries[std::size_t(row)].failure = reason;
  Q_EMIT dataChanged(index(row), index(row));
}

QStringList LibraryModel::pending() const {
  QStringList ids;
  for (const Entry& entry : m_entries)
    if (!entry.look && entry.failure.isEmpty()) ids << entry.item.id;
  return ids;
}

int LibraryModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_entries.size()); }

Qt::ItemFlags LibraryModel::flags(const QModelIndex& index) const {
  return QAbstractListModel::flags(index) | Qt::ItemIsDragEnabled;
}

QMimeData* LibraryModel::mimeData(const QModelIndexList& indexes) const {
  return indexes.isEmpty() ? nullptr : toDrag(indexes.front().data(IdRole).toString());
}

QVariant LibraryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Entry& entry = m_entries[std::size_t(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return entry.item.name;
    case Qt::DecorationRole:
      return entry.pixmap.isNull() ? QVariant() : entry.pixmap;
    case Qt::ToolTipRole:
      return QStringLiteral("<b>%1</b><br>%2%3")
          .arg(entry.item.name.toHtmlEscaped(), entry.item.toolTip.toHtmlEscaped(),
               entry.failure.isEmpty() ? QString() : "<br>" + entry.failure.toHtmlEscaped());
    case Qt::AccessibleDescriptionRole:
      return entry.item.toolTip;
    case IdRole:
      return entry.item.id;
    case HueRole:
      return entry.look ? entry.look->hue : 1e9;
    case RoughnessRole:
      return entry.look ? entry.look->roughness : 1e9;
    case FailureRole:
      return entry.failure;
    default:
      return {};
  }
}

}  // namespace gonio::widgets

#include "moc_library_model.cpp"
