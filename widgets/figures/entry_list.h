// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "widgets/figures/entry_list_model.h"

class QLabel;
class QMenu;
class QToolButton;
class QTreeView;

namespace gonio::widgets {

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
