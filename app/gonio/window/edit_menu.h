// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMenu>

class QSettings;

namespace gonio::widgets {
class PreviewWidget;
}

namespace gonio::app {

class Document;
class DocumentController;
class Inspector;

struct Preferences;

/// The Edit menu.
class EditMenu : public QMenu {
  Q_OBJECT

 public:
  /// @param showHistory action that shows and hides the list of undo steps.
  EditMenu(Document& document, DocumentController& controller, const Inspector& inspector,
           const widgets::PreviewWidget& preview, QSettings& settings, QAction* showHistory, QWidget* window);

 private:
  void addHistory(QAction* showHistory);
  void addEdits();
  void showPreferences();
  void apply(const Preferences& preferences);
  /// Stores the preferences chosen in the dialog and applies the changed ones.
  void adopt(const Preferences& chosen, const Preferences& before);

  Document& m_document;
  DocumentController& m_controller;
  const Inspector& m_inspector;
  const widgets::PreviewWidget& m_preview;
  QSettings& m_settings;
  bool m_pasteable = false;  ///< whether the clipboard contains edits
};

}  // namespace gonio::app
