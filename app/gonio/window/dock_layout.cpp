// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/dock_layout.h"

#include <QAction>
#include <QChildEvent>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QPointer>
#include <QScopeGuard>
#include <QSettings>
#include <QTabBar>
#include <QTimer>
#include <algorithm>
#include <utility>

namespace gonio::app {

namespace {
/// Raised when docks change in a way that makes a stored layout wrong.
constexpr int layoutVersion = 2;
constexpr int bottomDockLines = 22, acquisitionDockLines = 30;
/// Maximum initial width of a side dock, percent of the window: on a small screen there is room for two columns of the
/// library, and for sliders that are long enough to aim with.
constexpr int maxPercentLeft = 20, maxPercentRight = 34;
const QString geometryKey = QStringLiteral("window/geometry"), layoutKey = QStringLiteral("window/layout"),
              workspaceKey = QStringLiteral("window/workspace");
}  // namespace

DockLayout::DockLayout(QMainWindow& window) : QObject(&window), m_window(window) {
  // The inspector keeps its whole height beside the docks at the bottom.
  m_window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  // No grouped dragging: Qt 6.4 keeps groups of floating docks that it deletes too early.
  m_window.setDockOptions(QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
  m_window.installEventFilter(this);
  m_tabIcons.setSingleShot(true);
  m_tabIcons.setInterval(0);
  connect(&m_tabIcons, &QTimer::timeout, this, &DockLayout::showTabIcons);
}

void DockLayout::showTabIcons() {
  for (QTabBar* tabs : m_window.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
    for (int i = 0; i < tabs->count(); ++i) {
      const auto dock = std::ranges::find(m_docks, tabs->tabText(i), &QWidget::windowTitle);
      if (dock != m_docks.end() && tabs->tabIcon(i).isNull()) tabs->setTabIcon(i, (*dock)->toggleViewAction()->icon());
    }
}

bool DockLayout::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ChildPolished) {
    // Qt 6.4 divides by the size of a dragged tab, which may have none.
    if (auto* tabs = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child())) tabs->setMovable(false);
  }
  return QObject::eventFilter(watched, event);
}

QDockWidget* DockLayout::add(const QString& title, const QString& name, QWidget* content, Qt::DockWidgetArea area,
                             int lines) {
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
  // A dock behind others that is chosen in the menu comes to the front.
  connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool shown) {
    if (shown) dock->raise();
  });
  // Qt makes tabs as docks come to lie behind one another.
  for (const auto signal : {&QDockWidget::visibilityChanged, &QDockWidget::topLevelChanged})
    connect(dock, signal, &m_tabIcons, qOverload<>(&QTimer::start));
  connect(dock, &QDockWidget::dockLocationChanged, &m_tabIcons, qOverload<>(&QTimer::start));
  m_docks << dock;
  m_places.push_back({area, lines});
  return dock;
}

void DockLayout::setDefault() {
  for (std::size_t i = 0; i < m_places.size(); ++i) m_places[i].shown = !m_docks[qsizetype(i)]->isHidden();
  resizeSides();
}

void DockLayout::resizeSides() {
  QList<QDockWidget*> docks;
  QList<int> widths;
  for (std::size_t i = 0; i < m_places.size(); ++i) {
    if (m_places[i].lines == 0) continue;
    docks << m_docks[qsizetype(i)];
    const int percent = m_places[i].area == Qt::LeftDockWidgetArea ? maxPercentLeft : maxPercentRight;
    widths << std::min(m_places[i].lines * m_window.fontMetrics().height(), m_window.width() * percent / 100);
  }
  m_window.resizeDocks(docks, widths, Qt::Horizontal);
}

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

void DockLayout::addTabs(const QStringList& names, const std::function<void(Workspace)>& choose) {
  m_tabs = new QTabBar;
  m_tabs->setDrawBase(false);
  m_tabs->setExpanding(false);
  m_tabs->setAccessibleName(tr("Layouts"));
  for (int i = 0; i < names.size(); ++i) {
    m_tabs->addTab(names[i]);
    m_tabs->setTabToolTip(i, tr("Shows the panels of this layout (Ctrl+%1)").arg(i + 1));
  }
  // Not when the current tab changes: a press on it brings the panels of its layout back.
  connect(m_tabs, &QTabBar::tabBarClicked, this, [choose](int tab) {
    if (tab >= 0) choose(Workspace(tab));
  });
  connect(m_tabs, &QTabBar::currentChanged, this, [this, choose](int tab) {
    if (std::exchange(m_workspace, Workspace(tab)) != Workspace(tab)) choose(Workspace(tab));  // by the keyboard
  });
  m_window.menuBar()->setCornerWidget(m_tabs, Qt::TopRightCorner);
}

void DockLayout::showWorkspace(Workspace workspace) {
  m_workspace = workspace;
  if (m_tabs) m_tabs->setCurrentIndex(int(workspace));
  // Qt passes the focus of a panel that is hidden on to the next button, which Space would then press.
  const QPointer<QWidget> focused = m_window.focusWidget();
  const auto returnFocus = qScopeGuard([&] {
    if (focused) (focused->isVisible() ? focused.data() : m_window.centralWidget())->setFocus();
  });
  reset();
  switch (workspace) {
    case Workspace::edit:
      break;
    case Workspace::compare:
      show(QStringLiteral("library"), false);
      show(QStringLiteral("comparison"));
      break;
    case Workspace::analyse:
      show(QStringLiteral("plots"));
      break;
    case Workspace::acquire:
      for (const auto& name : {QStringLiteral("library"), QStringLiteral("inspector")}) show(name, false);
      for (const auto& name : {QStringLiteral("photographs"), QStringLiteral("acquisition")}) show(name);
      m_window.resizeDocks({dock(QStringLiteral("acquisition"))},
                           {acquisitionDockLines * m_window.fontMetrics().height()}, Qt::Vertical);
  }
}

void DockLayout::reset() {
  // By calls: restoring stored bytes over docks that float or lie behind one another crashes in Qt 6.4.
  for (QDockWidget* dock : m_docks) {
    dock->setFloating(false);
    m_window.removeDockWidget(dock);
  }
  QDockWidget* bottom = nullptr;
  for (std::size_t i = 0; i < m_places.size(); ++i) {
    QDockWidget* dock = m_docks[qsizetype(i)];
    m_window.addDockWidget(m_places[i].area, dock);
    if (m_places[i].area == Qt::BottomDockWidgetArea) {
      if (bottom) m_window.tabifyDockWidget(bottom, dock);
      bottom = dock;
    }
  }
  for (std::size_t i = 0; i < m_places.size(); ++i) m_docks[qsizetype(i)]->setVisible(m_places[i].shown);
  resizeSides();
}

void DockLayout::restore(const QSettings& settings) {
  m_window.restoreGeometry(settings.value(geometryKey).toByteArray());
  // Without a stored layout, widths that are asked for before the window is laid out come out smaller.
  if (!m_window.restoreState(settings.value(layoutKey).toByteArray(), layoutVersion))
    QTimer::singleShot(0, this, &DockLayout::resizeSides);
  const int workspace = std::clamp(settings.value(workspaceKey).toInt(), 0, int(Workspace::acquire));
  m_workspace = Workspace(workspace);
  if (m_tabs) m_tabs->setCurrentIndex(workspace);
}

void DockLayout::save(QSettings& settings) const {
  settings.setValue(workspaceKey, int(m_workspace));
  settings.setValue(geometryKey, m_window.saveGeometry());
  settings.setValue(layoutKey, m_window.saveState(layoutVersion));
}

}  // namespace gonio::app

#include "moc_dock_layout.cpp"
