// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QMenu>

class QSettings;

namespace gonio::widgets {
class PreviewWidget;
}

namespace gonio::app {

class ComparisonController;
class DockLayout;

/// The View menu: layouts, docks, tone map, exposure, light, theme.
class ViewMenu : public QMenu {
  Q_OBJECT

 public:
  /// @param light its Light submenu.
  ViewMenu(DockLayout& docks, ComparisonController& comparison, widgets::PreviewWidget& preview, QMenu* light,
           QSettings& settings, QWidget* window);

  /// Adds the actions on the picture to a context menu.
  void addPictureActionsTo(QMenu& menu);

 private:
  void addLayouts(QMenu* menu, ComparisonController& comparison);
  void addDocks();
  void addPicture();
  void addToneMap(QMenu* menu);
  void addTheme(QMenu* menu, QSettings& settings);
  void addWindow();
  void changeExposure(double stops);

  DockLayout& m_docks;
  widgets::PreviewWidget& m_preview;
  QList<QAction*> m_pictureActions;
};

}  // namespace gonio::app
