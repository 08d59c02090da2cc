// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

class QMenu;

namespace gonio::app {

class MainWindow;

/// The Edit menu.
class EditMenu : public QObject {
  Q_OBJECT

 public:
  explicit EditMenu(MainWindow& window);

 private:
  void addHistory(QMenu* menu);
  void addEdits(QMenu* menu);
  void showPreferences();

  MainWindow& m_window;
  bool m_pasteable = false;  ///< what the clipboard holds
};

}  // namespace gonio::app
