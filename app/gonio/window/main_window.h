// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMainWindow>

#include "app/gonio/inspector/inspector.h"
#include "app/gonio/window/document_files.h"
#include "app/gonio/window/editor_parts.h"

namespace gonio::widgets {
class MessageBar;
}

namespace gonio::app {

class ActionTable;
class DockLayout;
class StartPage;
class StatusLine;

/// The editor's window: library left, preview in the middle, inspector right. It arranges the parts of the editor and
/// creates the menus; the parts do not depend on it.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  /// For start-up and tests.
  EditorParts& parts() { return m_parts; }
  DocumentFiles& files() { return m_files; }
  DockLayout& docks() { return *m_docks; }
  ActionTable& actionTable() { return *m_actions; }
  StartPage& startPage() { return *m_start; }

  /// Closes all windows, after one question that names every document with unsaved changes. Nothing is closed if the
  /// user cancels, or if a document could not be saved.
  static void quit();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void addCentre();
  void addDocks();
  void addMenus();
  void connectDocument();
  void connectNotes();
  void showLostNotes();
  void connectMessages();
  void connectRequests();
  void connectStartPage();
  void connectKinds();
  void showKind(EditingKind kind);
  void showFolder(const QString& folder);
  void comparePair(const QString& first, const QString& second);
  void showFailure(const QString& title, const QString& text);
  void showTitle();
  void showGround();
  void showPictureMenu(const QPoint& place);
  void chooseMaterial(const QString& title, const std::function<void(const QString& path)>& chosen);

  EditorParts m_parts;
  DocumentFiles m_files;
  DockLayout* m_docks;
  StatusLine* m_status = nullptr;
  ActionTable* m_actions = nullptr;
  widgets::MessageBar* m_messages;
  StartPage* m_start;
  QString m_lostNotes;  ///< last message about notes that cannot be read or saved
};

}  // namespace gonio::app
