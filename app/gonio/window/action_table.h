// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <functional>
#include <vector>

class QAction;
class QMainWindow;
class QMenu;

namespace gonio::app {

/// A row of the table of actions: an action of a menu, a submenu, or, if everything is empty, a line between two groups
/// of actions.
struct Action {
  QString id = {};  ///< for ActionTable::action(); empty if nothing asks for it
  QString text = {};
  QString icon = {};  ///< of resources/icons
  QList<QKeySequence> keys = {};
  QString help = {};  ///< one sentence: the tooltip, and further words by which the command search finds the action
  std::function<void()> run = {};
  std::function<bool()> enabled = {};         ///< null: always
  std::function<bool()> checked = {};         ///< null: without a mark
  bool isChoice = false;                      ///< one of the choices of its menu, of which one is checked
  std::function<QString()> currentText = {};  ///< of an action whose text changes
  std::vector<Action> rows = {};              ///< of a submenu
  /// Stands for the rows that it returns whenever the menu is opened or searched.
  std::function<std::vector<Action>()> currentRows = {};
  QAction* existing = nullptr;  ///< an action that belongs to another object, e.g. to a dock; it has its own text
};

/// An action that can be run, with its path, e.g. "File > Open Recent > a.binary".
struct NamedAction {
  QString path;
  QAction* action;
};

/// The actions of a window. The menu bar, the command search and the list of shortcuts show this table.
class ActionTable : public QObject {
  Q_OBJECT

 public:
  /// Adds the menus to the window's menu bar.
  ActionTable(QMainWindow& window, const std::vector<Action>& menus);

  /// All actions in the order of the menus, with their current rows and states.
  QList<NamedAction> all();
  /// The action or submenu with this id.
  QAction* action(const QString& id) const;

 public Q_SLOTS:
  /// Shows the current texts, and which actions are enabled and checked. To be called when anything changes on which
  /// these depend; a menu that opens calls it too.
  void update();

 private:
  /// Rows that change, and the actions that show them now.
  struct Changing {
    QMenu* menu;
    QAction* next;  ///< the row after them; null: none
    std::function<std::vector<Action>()> rows;
    QList<QAction*> actions;
  };

  void fill(QMenu& menu, const std::vector<Action>& rows);
  QAction* add(QMenu& menu, const Action& row, QAction* before = nullptr);
  QAction* create(QMenu& menu, const Action& row);
  void updateRows(Changing& changing);

  QMainWindow& m_window;
  std::vector<std::pair<Action, QAction*>> m_actions;  ///< that do not come from changing rows
  std::vector<Changing> m_changing;
};

}  // namespace gonio::app
