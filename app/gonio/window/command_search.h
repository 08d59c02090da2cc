// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>
#include <functional>
#include <vector>

class QLineEdit;
class QListWidget;

namespace gonio::widgets {
class LibraryModel;
}

namespace gonio::app {

class ActionTable;
class Document;
class DocumentController;
class DocumentFiles;
class EnvironmentController;
class Inspector;
class ScenePanel;

/// A result of the search that can be run.
struct SearchEntry {
  QString text;      ///< e.g. "Library > chrome"
  QString keywords;  ///< further words by which it is found
  std::function<void()> run;
  QString shortcut = {};
  bool enabled = true;
  bool isCommand = false;  ///< also listed for an empty search text
};

/// Search for actions, sliders, models, scenes, lights, the current materials of the library and pages of the guide, by
/// words in any order. Entries are listed in this order: each word begins a word of the text; each begins a word of the
/// text or the keywords; each stands anywhere in them.
class CommandSearch : public QDialog {
  Q_OBJECT

 public:
  /// What is searched, and what shows or opens the results.
  struct Parts {
    ActionTable& actions;
    const Document& document;
    DocumentController& controller;
    DocumentFiles& files;
    Inspector& inspector;
    ScenePanel& scene;
    EnvironmentController& environment;
    const widgets::LibraryModel& library;
  };
  CommandSearch(const Parts& parts, QWidget* window);

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
