// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

class QMenu;

namespace gonio::app {

class MainWindow;

/// The View menu: layouts, docks, tone map, exposure, light, theme.
class ViewMenu : public QObject {
  Q_OBJECT

 public:
  explicit ViewMenu(MainWindow& window);

 private:
  void addLayouts(QMenu* menu);
  void addDocks(QMenu* menu);
  void addPicture(QMenu* menu);
  void addToneMap(QMenu* menu);
  void addLight(QMenu* menu);
  void addTheme(QMenu* menu);
  void addWindow(QMenu* menu);
  void changeExposure(double stops);

  MainWindow& m_window;
};

}  // namespace gonio::app
