// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

namespace gonio::widgets {

/// A row or column of a figure as an entry of a list.
struct ListEntry {
  QString name, toolTip;
  QString label;                   ///< set by the user; empty: usualLabel
  QString usualLabel;              ///< default label, shown in grey if the user set none
  std::optional<int> budget = {};  ///< nullopt: it has none
  int maxBudget = 0;
};

/// The entries of a list: names, optional budgets, and labels, which can be edited. Edits are reported by signals and
/// not stored: the owner updates them with setEntries().
class EntryListModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  EntryListModel(const QString& nameTitle, bool hasBudgets, QObject* parent = nullptr);

  void setEntries(std::vector<ListEntry> entries);
  int labelColumn() const { return m_hasBudgets ? 2 : 1; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  void labelEdited(int row, const QString& label);
  void budgetEdited(int row, int budget);

 private:
  const QString m_nameTitle;
  const bool m_hasBudgets;
  std::vector<ListEntry> m_entries;
};

}  // namespace gonio::widgets
