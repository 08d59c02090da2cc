// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/figures/entry_list_model.h"

#include <QGuiApplication>
#include <QPalette>

namespace gonio::widgets {

namespace {
enum Column { nameColumn, budgetColumn };
}

EntryListModel::EntryListModel(const QString& nameTitle, bool hasBudgets, QObject* parent)
    : QAbstractTableModel(parent), m_nameTitle(nameTitle), m_hasBudgets(hasBudgets) {}

void EntryListModel::setEntries(std::vector<ListEntry> entries) {
  // Remaining rows keep the selection and an open editor.
  const int before = rowCount(), after = int(entries.size());
  if (after > before) beginInsertRows({}, before, after - 1);
  if (after < before) beginRemoveRows({}, after, before - 1);
  m_entries = std::move(entries);
  if (after > before) endInsertRows();
  if (after < before) endRemoveRows();
  if (after > 0) Q_EMIT dataChanged(index(0, 0), index(after - 1, labelColumn()));
}

int EntryListModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_entries.size()); }
int EntryListModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : labelColumn() + 1; }

QVariant EntryListModel::data(const QModelIndex& index, int role) const {
  const ListEntry& entry = m_entries[std::size_t(index.row())];
  const bool isLabel = index.column() == labelColumn(), isBudget = m_hasBudgets && index.column() == budgetColumn;
  if (role == Qt::EditRole) {
    if (isLabel) return entry.label;
    if (isBudget && entry.budget) return *entry.budget;
  }
  if (role == Qt::DisplayRole) {
    if (isLabel) return entry.label.isEmpty() ? entry.usualLabel : entry.label;
    if (isBudget) return entry.budget ? QVariant(*entry.budget) : QVariant();
    return entry.name;
  }
  if (role == Qt::ToolTipRole && index.column() == nameColumn) return entry.toolTip;
  if (role == Qt::ToolTipRole && isLabel) return tr("Label in the figure; double-click or press F2 to edit it");
  if (role == Qt::ToolTipRole && isBudget && entry.budget)
    return tr("Budget, 1 to %1; double-click to edit").arg(entry.maxBudget);
  if (role == Qt::ForegroundRole && isLabel && entry.label.isEmpty())
    return QGuiApplication::palette().color(QPalette::PlaceholderText);
  if (role == Qt::TextAlignmentRole && isBudget) return int(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

QVariant EntryListModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  if (section == labelColumn()) return tr("Label");
  return section == nameColumn ? m_nameTitle : tr("Budget");
}

Qt::ItemFlags EntryListModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  if (!index.isValid()) return flags;
  const bool hasBudget = m_hasBudgets && index.column() == budgetColumn && m_entries[std::size_t(index.row())].budget;
  if (hasBudget || index.column() == labelColumn()) flags |= Qt::ItemIsEditable;
  return flags;
}

bool EntryListModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable)) return false;
  const ListEntry& entry = m_entries[std::size_t(index.row())];
  if (index.column() == labelColumn()) {
    if (const QString label = value.toString().trimmed(); label != entry.label) Q_EMIT labelEdited(index.row(), label);
    return true;
  }
  const int budget = value.toInt();
  if (budget < 1 || budget > entry.maxBudget) return false;
  if (budget != entry.budget) Q_EMIT budgetEdited(index.row(), budget);
  return true;
}

}  // namespace gonio::widgets

#include "moc_entry_list_model.cpp"
