// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMenu>
#include <functional>

namespace gonio::app {

class DockLayout;
class DocumentFiles;
class LibraryController;

/// The File menu.
class FileMenu : public QMenu {
  Q_OBJECT

 public:
  FileMenu(DocumentFiles& files, LibraryController& library, DockLayout& docks, const std::function<void()>& newWindow,
           QWidget* window);

 private:
  void addOpening(const std::function<void()>& newWindow);
  void addSaving();
  void fillRecent(QMenu* menu);
  void openFolder();

  DocumentFiles& m_files;
  LibraryController& m_library;
  DockLayout& m_docks;
};

}  // namespace gonio::app
