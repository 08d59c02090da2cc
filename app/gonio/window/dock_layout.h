// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QList>
#include <QObject>
#include <QTimer>
#include <functional>
#include <vector>

class QDockWidget;
class QMainWindow;
class QSettings;
class QTabBar;

namespace gonio::app {

/// The docks of a window, identified by their object names, and the docks of each workspace.
class DockLayout : public QObject {
  Q_OBJECT

 public:
  enum class Workspace { edit, compare, analyse, acquire };

  explicit DockLayout(QMainWindow& window);

  /// Adds a dock. Docks at the bottom are tabbed and initially hidden.
  /// @param lines width at a side, in line heights; 0: the width of its content.
  QDockWidget* add(const QString& title, const QString& name, QWidget* content, Qt::DockWidgetArea area, int lines = 0);
  /// Stores the layout for reset(). Call it after the last add().
  void setDefault();
  const QList<QDockWidget*>& docks() const { return m_docks; }
  QDockWidget* dock(const QString& name) const;
  /// Shows and raises a dock, or hides it.
  void show(const QString& name, bool shown = true);
  void showWorkspace(Workspace workspace);
  /// A tab for each workspace, with these names, in the row of the menus. The current one is the workspace that was
  /// chosen last. @param choose shows a workspace.
  void addTabs(const QStringList& names, const std::function<void(Workspace)>& choose);
  QTabBar* tabs() const { return m_tabs; }
  void reset();

  /// Restores the window's geometry and its docks.
  void restore(const QSettings& settings);
  void save(QSettings& settings) const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void resizeSides();
  /// Tabs of docks get the icons of their menu entries.
  void showTabIcons();

  QMainWindow& m_window;
  QTimer m_tabIcons;  ///< until tabs that come to be are there
  QTabBar* m_tabs = nullptr;
  Workspace m_workspace = Workspace::edit;  ///< chosen last
  QList<QDockWidget*> m_docks;
  struct Place {
    Qt::DockWidgetArea area;
    int lines;  ///< width in line heights
    bool shown = true;
  };
  std::vector<Place> m_places;  ///< of m_docks
};

}  // namespace gonio::app
