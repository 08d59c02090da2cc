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

/// Every action of a window that has a text, by menu: path is "File > Open Recent > a.binary".
struct NamedAction {
  QString path;
  QAction* action;
};
QList<NamedAction> allActions(const QWidget* window);

/// Something that a search finds and does.
struct SearchEntry {
  QString text;      ///< "Library > chrome"
  QString keywords;  ///< other words that find it
  std::function<void()> run;
  QString shortcut = {};
  bool enabled = true;
  bool isCommand = false;  ///< listed also before anything is typed
};

/// Finds commands, and whatever else it is given, by typing parts of names in any order, and runs them. What has all
/// the words in its text comes before what has them in its keywords.
class CommandSearch : public QDialog {
  Q_OBJECT

 public:
  /// @param others beside the window's actions.
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
