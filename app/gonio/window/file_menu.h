// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMenu>
#include <functional>

class QSettings;

namespace gonio::widgets {
class PreviewContent;
}

namespace gonio::app {

class DockLayout;
class DocumentFiles;
class ExportController;
class LibraryController;

/// The File menu.
class FileMenu : public QMenu {
  Q_OBJECT

 public:
  /// What concerns all windows.
  struct WindowActions {
    std::function<void()> openNew, quit;
  };

  FileMenu(DocumentFiles& files, ExportController& exporter, const widgets::PreviewContent& preview,
           LibraryController& library, DockLayout& docks, QSettings& settings, const WindowActions& windows,
           QWidget* window);

 private:
  void addOpening(const std::function<void()>& newWindow);
  void addSaving();
  void fillRecent(QMenu* menu);
  void openFolder();
  void exportForRenderer();

  DocumentFiles& m_files;
  ExportController& m_exporter;
  const widgets::PreviewContent& m_preview;
  LibraryController& m_library;
  DockLayout& m_docks;
  QSettings& m_settings;
};

}  // namespace gonio::app
