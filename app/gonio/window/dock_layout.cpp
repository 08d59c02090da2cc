// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/dock_layout.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QSettings>
#include <algorithm>

namespace gonio::app {

namespace {
/// Raised when docks change in a way that makes a stored layout wrong.
constexpr int layoutVersion = 1;
constexpr int bottomDockLines = 22, acquisitionDockLines = 30;
const QString geometryKey = QStringLiteral("window/geometry"), layoutKey = QStringLiteral("window/layout");
}  // namespace

DockLayout::DockLayout(QMainWindow& window) : QObject(&window), m_window(window) {
  m_window.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks |
                          QMainWindow::GroupedDragging);
}

QDockWidget* DockLayout::add(const QString& title, const QString& name, QWidget* content, Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, &m_window);
  dock->setObjectName(name);
  dock->setWidget(content);
  m_window.addDockWidget(area, dock);
  if (area == Qt::BottomDockWidgetArea) {
    const auto before = std::ranges::find(m_docks.rbegin(), m_docks.rend(), area,
                                          [this](QDockWidget* one) { return m_window.dockWidgetArea(one); });
    if (before != m_docks.rend()) m_window.tabifyDockWidget(*before, dock);
    dock->hide();
  }
  m_docks << dock;
  return dock;
}

void DockLayout::setDefault() { m_default = m_window.saveState(layoutVersion); }

QDockWidget* DockLayout::dock(const QString& name) const {
  const auto found = std::ranges::find(m_docks, name, &QObject::objectName);
  Q_ASSERT(found != m_docks.end());
  return *found;
}

void DockLayout::show(const QString& name, bool shown) {
  QDockWidget* shownDock = dock(name);
  const bool wasHidden = shownDock->isHidden();
  shownDock->setVisible(shown);
  if (!shown) return;
  shownDock->raise();
  if (wasHidden && m_window.dockWidgetArea(shownDock) == Qt::BottomDockWidgetArea)
    m_window.resizeDocks({shownDock}, {bottomDockLines * m_window.fontMetrics().height()}, Qt::Vertical);
}

void DockLayout::showWorkspace(Workspace workspace) {
  reset();
  switch (workspace) {
    case Workspace::edit:
      break;
    case Workspace::compare:
      show(QStringLiteral("library"), false);
      show(QStringLiteral("comparison"));
      break;
    case Workspace::analyse:
      show(QStringLiteral("models"));
      show(QStringLiteral("plots"));
      break;
    case Workspace::acquire:
      for (const auto& name : {QStringLiteral("library"), QStringLiteral("inspector")}) show(name, false);
      show(QStringLiteral("acquisition"));
      m_window.resizeDocks({dock(QStringLiteral("acquisition"))},
                           {acquisitionDockLines * m_window.fontMetrics().height()}, Qt::Vertical);
  }
}

void DockLayout::reset() {
  for (QDockWidget* dock : m_docks) dock->setFloating(false);
  m_window.restoreState(m_default, layoutVersion);
}

void DockLayout::restore(const QSettings& settings) {
  m_window.restoreGeometry(settings.value(geometryKey).toByteArray());
  m_window.restoreState(settings.value(layoutKey).toByteArray(), layoutVersion);
}

void DockLayout::save(QSettings& settings) const {
  settings.setValue(geometryKey, m_window.saveGeometry());
  settings.setValue(layoutKey, m_window.saveState(layoutVersion));
}

}  // namespace gonio::app

#include "moc_dock_layout.cpp"
