// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QAbstractTableModel>
#include <QWidget>
#include <optional>
#include <vector>

class QLabel;
class QMenu;
class QToolButton;
class QTreeView;

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

/// A list with buttons and keys to add entries (from a menu), remove them (Delete), move them (Alt+Up, Alt+Down) and
/// edit their labels (F2).
class EntryList : public QWidget {
  Q_OBJECT

 public:
  /// @param nameTitle title of the name column, also the accessible name of the list.
  EntryList(const QString& nameTitle, bool hasBudgets, QWidget* parent = nullptr);

  /// @param full whether no more entries can be added.
  void setEntries(std::vector<ListEntry> entries, bool full);
  /// Sets the text shown while the list is empty.
  void setEmptyText(const QString& text);
  QMenu& addMenu() const { return *m_menu; }
  EntryListModel& model() { return m_model; }
  QTreeView& view() const { return *m_view; }
  /// The selected row; -1: none.
  int current() const;
  void select(int row);

 Q_SIGNALS:
  void removeRequested(int row);
  void moveRequested(int from, int to);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QToolButton* button(const QString& text, const QString& toolTip);
  void move(int by);
  void refresh();

  EntryListModel m_model;
  QTreeView* m_view;
  QLabel* m_empty;
  QMenu* m_menu;
  QToolButton *m_add, *m_remove, *m_up, *m_down;
};

}  // namespace gonio::widgets
