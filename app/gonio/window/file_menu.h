// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

class QAction;
class QMenu;

namespace gonio::app {

class MainWindow;

/// The File menu and what its actions ask.
class FileMenu : public QObject {
  Q_OBJECT

 public:
  explicit FileMenu(MainWindow& window);

 private:
  void addOpening(QMenu* menu);
  void addSaving(QMenu* menu);
  void fillRecent(QMenu* menu);
  void openFile();
  void openFolder();
  void exportBrdf();
  void exportImage();

  MainWindow& m_window;
};

}  // namespace gonio::app
