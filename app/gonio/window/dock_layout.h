// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QList>
#include <QObject>
#include <vector>

class QDockWidget;
class QMainWindow;
class QSettings;

namespace gonio::app {

/// The docks of a window by their object names, and which of them each kind of work shows.
class DockLayout : public QObject {
  Q_OBJECT

 public:
  enum class Workspace { edit, compare, analyse, acquire };

  explicit DockLayout(QMainWindow& window);

  /// Docks at the bottom lie behind one another, and are hidden at first.
  /// @param lines its width at a side, in heights of a line; 0: as its content asks.
  QDockWidget* add(const QString& title, const QString& name, QWidget* content, Qt::DockWidgetArea area, int lines = 0);
  /// After the last add(): what reset() goes back to.
  void setDefault();
  const QList<QDockWidget*>& docks() const { return m_docks; }
  QDockWidget* dock(const QString& name) const;
  /// Brings a dock to the front, or takes it away.
  void show(const QString& name, bool shown = true);
  void showWorkspace(Workspace workspace);
  void reset();

  /// The window's geometry and its docks.
  void restore(const QSettings& settings);
  void save(QSettings& settings) const;

 private:
  void resizeSides();

  QMainWindow& m_window;
  QList<QDockWidget*> m_docks;
  struct Place {
    Qt::DockWidgetArea area;
    int lines;  ///< its width
    bool shown = true;
  };
  std::vector<Place> m_places;  ///< of m_docks
};

}  // namespace gonio::app
