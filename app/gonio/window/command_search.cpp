// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/command_search.h"

#include <QAction>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QVBoxLayout>
#include <algorithm>

namespace gonio::app {

namespace {

QString plainText(const QAction* action) { return action->text().remove('&').remove(QStringLiteral("...")); }

void collect(const QMenu* menu, const QString& prefix, QList<NamedAction>& found) {
  for (QAction* action : menu->actions()) {
    if (action->isSeparator() || action->text().isEmpty()) continue;
    const QString path = prefix + plainText(action);
    if (action->menu())
      collect(action->menu(), path + QStringLiteral(" > "), found);
    else
      found.append({path, action});
  }
}

/// Whether every word of the query occurs in the text.
bool matches(const QString& text, const QString& query) {
  const QStringList words = query.split(' ', Qt::SkipEmptyParts);
  return std::all_of(words.begin(), words.end(),
                     [&](const QString& w) { return text.contains(w, Qt::CaseInsensitive); });
}

}  // namespace

QList<NamedAction> allActions(const QWidget* window) {
  QList<NamedAction> found;
  const auto* mainWindow = qobject_cast<const QMainWindow*>(window);
  if (!mainWindow || !mainWindow->menuWidget()) return found;
  for (const QAction* top : qobject_cast<QMenuBar*>(mainWindow->menuWidget())->actions())
    if (top->menu()) collect(top->menu(), plainText(top) + QStringLiteral(" > "), found);
  return found;
}

CommandSearch::CommandSearch(QWidget* window)
    : QDialog(window, Qt::Popup),
      m_actions(allActions(window)),
      m_text(new QLineEdit(this)),
      m_list(new QListWidget(this)) {
  m_text->setPlaceholderText(tr("Search every command"));
  m_text->setAccessibleName(tr("Search every command"));
  m_list->setAccessibleName(tr("Commands"));
  m_list->setFocusPolicy(Qt::NoFocus);
  m_text->installEventFilter(this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(m_text);
  layout->addWidget(m_list);
  const int em = fontMetrics().height();
  resize(em * 32, em * 24);
  move(window->mapToGlobal(QPoint((window->width() - width()) / 2, em * 4)));
  connect(m_text, &QLineEdit::textChanged, this, &CommandSearch::filter);
  connect(m_list, &QListWidget::itemActivated, this, &CommandSearch::runCurrent);
  connect(m_list, &QListWidget::itemClicked, this, &CommandSearch::runCurrent);
  filter({});
  m_text->setFocus();  // a popup takes no focus by itself
}

void CommandSearch::filter(const QString& text) {
  m_list->clear();
  for (int i = 0; i < m_actions.size(); ++i) {
    const NamedAction& named = m_actions[i];
    if (!matches(named.path, text)) continue;
    const QString shortcut = named.action->shortcut().toString(QKeySequence::NativeText);
    auto* item = new QListWidgetItem(shortcut.isEmpty() ? named.path : named.path + QStringLiteral("    ") + shortcut);
    item->setData(Qt::UserRole, i);
    if (!named.action->isEnabled()) item->setFlags(Qt::NoItemFlags);
    m_list->addItem(item);
  }
  m_list->setCurrentRow(0);
}

bool CommandSearch::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    runCurrent();
    return true;
  }
  if (key == Qt::Key_Up || key == Qt::Key_Down) {
    const int row = m_list->currentRow() + (key == Qt::Key_Down ? 1 : -1);
    m_list->setCurrentRow(std::clamp(row, 0, m_list->count() - 1));
    return true;
  }
  return QDialog::eventFilter(watched, event);
}

void CommandSearch::runCurrent() {
  const QListWidgetItem* item = m_list->currentItem();
  if (!item || !(item->flags() & Qt::ItemIsEnabled)) return;
  const QPointer<QAction> action = m_actions[item->data(Qt::UserRole).toInt()].action;
  accept();
  if (action) action->trigger();
}

}  // namespace gonio::app

#include "moc_command_search.cpp"
