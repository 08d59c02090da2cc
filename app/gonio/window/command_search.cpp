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
#include <QRegularExpression>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>

#include "widgets/inputs/menu_text.h"

namespace gonio::app {

namespace {

QString plainText(const QAction* action) {
  return widgets::withoutKeyMarks(action->text()).remove(QStringLiteral("..."));
}

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

/// How well an entry matches: each word begins one of its text, or of its text and keywords, or stands anywhere in
/// them.
enum class Match { text, keywords, anywhere, none };

bool beginsAll(const QString& text, const QStringList& words) {
  static const QRegularExpression between(QStringLiteral("[^\\p{L}\\p{N}]+"));
  const QStringList own = text.split(between, Qt::SkipEmptyParts);
  return std::ranges::all_of(words, [&](const QString& word) {
    return std::ranges::any_of(own, [&](const QString& one) { return one.startsWith(word, Qt::CaseInsensitive); });
  });
}

Match matchOf(const SearchEntry& entry, const QStringList& words) {
  if (words.isEmpty()) return entry.isCommand ? Match::text : Match::none;
  if (beginsAll(entry.text, words)) return Match::text;
  const QString all = entry.text + ' ' + entry.keywords;
  if (beginsAll(all, words)) return Match::keywords;
  const bool isThere =
      std::ranges::all_of(words, [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
  return isThere ? Match::anywhere : Match::none;
}

SearchEntry entryOf(const NamedAction& named) {
  const QPointer<QAction> action = named.action;
  // A tooltip that only repeats the text adds nothing.
  return {.text = named.path,
          .keywords = named.action->toolTip(),
          .run =
              [action] {
                if (action) action->trigger();
              },
          .shortcut = named.action->shortcut().toString(QKeySequence::NativeText),
          .enabled = named.action->isEnabled(),
          .isCommand = true};
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

CommandSearch::CommandSearch(QWidget* window, std::vector<SearchEntry> others)
    : QDialog(window, Qt::Popup), m_text(new QLineEdit(this)), m_list(new QListWidget(this)) {
  for (const NamedAction& named : allActions(window)) m_entries.push_back(entryOf(named));
  std::ranges::move(others, std::back_inserter(m_entries));
  m_text->setPlaceholderText(tr("Search commands, materials, parameters, scenes"));
  m_text->setAccessibleName(tr("Search commands, materials, parameters, scenes"));
  m_list->setAccessibleName(tr("Search results"));
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

void CommandSearch::add(int entry) {
  const SearchEntry& one = m_entries[std::size_t(entry)];
  auto* item =
      new QListWidgetItem(one.shortcut.isEmpty() ? one.text : one.text + QStringLiteral("    ") + one.shortcut);
  item->setData(Qt::UserRole, entry);
  if (!one.enabled) item->setFlags(Qt::NoItemFlags);
  m_list->addItem(item);
}

void CommandSearch::filter(const QString& text) {
  m_list->clear();
  const QStringList words = text.split(' ', Qt::SkipEmptyParts);
  std::vector<Match> matches;
  for (const SearchEntry& entry : m_entries) matches.push_back(matchOf(entry, words));
  for (const Match match : {Match::text, Match::keywords, Match::anywhere})
    for (int i = 0; i < int(m_entries.size()); ++i)
      if (matches[std::size_t(i)] == match) add(i);
  if (m_list->count() == 0) {
    auto* none = new QListWidgetItem(tr("No entry matches \"%1\".").arg(text));
    none->setFlags(Qt::NoItemFlags);
    m_list->addItem(none);
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
  const std::function<void()> run = m_entries[std::size_t(item->data(Qt::UserRole).toInt())].run;
  accept();
  run();
}

}  // namespace gonio::app

#include "moc_command_search.cpp"
