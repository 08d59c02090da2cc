// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/action_table.h"

#include <QActionGroup>
#include <QMainWindow>
#include <QMenuBar>
#include <QPointer>
#include <algorithm>
#include <utility>

#include "widgets/inputs/icons.h"
#include "widgets/inputs/menu_text.h"

namespace gonio::app {

namespace {

void showState(const Action& row, QAction& action) {
  if (row.currentText) action.setText(row.currentText());
  if (row.enabled) action.setEnabled(row.enabled());
  if (row.checked) action.setChecked(row.checked());
}

void collectActions(const QWidget& menu, const QString& prefix, QList<NamedAction>& found) {
  for (QAction* action : menu.actions()) {
    if (action->isSeparator()) continue;
    const QString path = prefix + widgets::withoutKeyMarks(action->text()).remove(QStringLiteral("..."));
    if (action->menu())
      collectActions(*action->menu(), path + QStringLiteral(" > "), found);
    else
      found.append({path, action});
  }
}

}  // namespace

ActionTable::ActionTable(QMainWindow& window, const std::vector<Action>& menus) : QObject(&window), m_window(window) {
  for (const Action& menu : menus) fill(*window.menuBar()->addMenu(menu.text), menu.rows);
  update();
}

void ActionTable::fill(QMenu& menu, const std::vector<Action>& rows) {
  const std::size_t first = m_changing.size();
  for (const Action& row : rows) {
    if (row.currentRows) {
      menu.setToolTipsVisible(true);  // the paths of files
      m_changing.push_back({&menu, nullptr, row.currentRows, {}});
      continue;
    }
    QAction* action = add(menu, row);
    m_actions.emplace_back(row, action);
    for (std::size_t i = first; i < m_changing.size(); ++i)
      if (m_changing[i].menu == &menu && !m_changing[i].next) m_changing[i].next = action;
  }
  connect(&menu, &QMenu::aboutToShow, this, [this, &menu] {
    for (Changing& changing : m_changing)
      if (changing.menu == &menu) updateRows(changing);
    update();
  });
}

/// @param before an action of the menu; null: adds the row at the end.
QAction* ActionTable::add(QMenu& menu, const Action& row, QAction* before) {
  QAction* action = row.existing ? row.existing : create(menu, row);
  if (!row.id.isEmpty()) action->setObjectName(row.id);
  if (!row.keys.isEmpty()) action->setShortcuts(row.keys);
  if (!row.help.isEmpty()) action->setToolTip(row.help);
  if (!row.icon.isEmpty()) action->setIcon(widgets::themedIcon(row.icon));
  menu.insertAction(before, action);
  return action;
}

QAction* ActionTable::create(QMenu& menu, const Action& row) {
  if (!row.rows.empty()) {
    auto* submenu = new QMenu(row.text, &menu);
    fill(*submenu, row.rows);
    return submenu->menuAction();
  }
  auto* action = new QAction(row.text, &menu);
  action->setSeparator(row.text.isEmpty() && !row.currentText);
  action->setCheckable(bool(row.checked));
  if (row.isChoice) {
    auto* group = menu.findChild<QActionGroup*>(QString(), Qt::FindDirectChildrenOnly);
    action->setActionGroup(group ? group : new QActionGroup(&menu));
  }
  showState(row, *action);
  if (row.run)
    connect(action, &QAction::triggered, this, [self = QPointer(this), run = row.run] {
      run();
      if (self) self->update();  // the window may be gone
    });
  return action;
}

void ActionTable::updateRows(Changing& changing) {
  qDeleteAll(std::exchange(changing.actions, {}));
  for (const Action& row : changing.rows()) changing.actions << add(*changing.menu, row, changing.next);
}

void ActionTable::update() {
  for (const auto& [row, action] : m_actions) showState(row, *action);
}

QList<NamedAction> ActionTable::all() {
  for (Changing& changing : m_changing) updateRows(changing);
  update();
  QList<NamedAction> found;
  collectActions(*m_window.menuBar(), {}, found);
  return found;
}

QAction* ActionTable::action(const QString& id) const {
  const auto found = std::ranges::find(m_actions, id, [](const auto& one) { return one.first.id; });
  Q_ASSERT(found != m_actions.end());
  return found->second;
}

}  // namespace gonio::app

#include "moc_action_table.cpp"
