// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>
#include <functional>
#include <vector>

class QAction;
class QLineEdit;
class QListWidget;

namespace gonio::app {

/// An action of a window's menus, with its path, e.g. "File > Open Recent > a.binary".
struct NamedAction {
  QString path;
  QAction* action;
};
QList<NamedAction> allActions(const QWidget* window);

/// A result of the search that can be run.
struct SearchEntry {
  QString text;      ///< e.g. "Library > chrome"
  QString keywords;  ///< further words by which it is found
  std::function<void()> run;
  QString shortcut = {};
  bool enabled = true;
  bool isCommand = false;  ///< also listed for an empty search text
};

/// Search for commands and other entries by words in any order. Entries are listed in this order: each word begins a
/// word of the text; each begins a word of the text or the keywords; each stands anywhere in them.
class CommandSearch : public QDialog {
  Q_OBJECT

 public:
  /// @param others entries in addition to the window's actions.
  explicit CommandSearch(QWidget* window, std::vector<SearchEntry> others = {});

  QListWidget* list() const { return m_list; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void filter(const QString& text);
  void add(int entry);
  void runCurrent();

  std::vector<SearchEntry> m_entries;
  QLineEdit* m_text;
  QListWidget* m_list;
};

}  // namespace gonio::app
