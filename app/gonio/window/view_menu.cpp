// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/view_menu.h"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QSettings>

#include "app/gonio/comparison/comparison_controller.h"
#include "app/gonio/window/dock_layout.h"
#include "app/gonio/window/theme.h"
#include "widgets/preview/preview_overlay.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {
constexpr double exposureStep = 0.5, darkest = -10, brightest = 10;
}

ViewMenu::ViewMenu(DockLayout& docks, ComparisonController& comparison, widgets::PreviewWidget& preview, QMenu* light,
                   QSettings& settings, QWidget* window)
    : QMenu(tr("&View"), window), m_docks(docks), m_preview(preview) {
  addLayouts(addMenu(tr("La&youts")), comparison);
  addDocks();
  addSeparator();
  addPicture();
  addToneMap(addMenu(tr("&Tone Map")));
  addMenu(light);
  m_pictureActions << light->menuAction();
  addSeparator();
  addTheme(addMenu(tr("T&heme")), settings);
  addWindow();
}

void ViewMenu::addLayouts(QMenu* menu, ComparisonController& comparison) {
  using Workspace = DockLayout::Workspace;
  const auto add = [&](const QString& text, Qt::Key key, Workspace workspace) {
    return menu->addAction(text, QKeySequence(Qt::CTRL | key), this,
                           [this, workspace] { m_docks.showWorkspace(workspace); });
  };
  add(tr("&Edit"), Qt::Key_1, Workspace::edit);
  connect(add(tr("&Compare"), Qt::Key_2, Workspace::compare), &QAction::triggered, &comparison, [&comparison] {
    if (comparison.comparison().mode == widgets::CompareMode::off) comparison.toggle();
  });
  add(tr("&Analyse"), Qt::Key_3, Workspace::analyse);
  add(tr("Ac&quire"), Qt::Key_4, Workspace::acquire);
}

void ViewMenu::addDocks() {
  int number = 1;
  for (QDockWidget* dock : m_docks.docks()) {
    QAction* action = dock->toggleViewAction();
    // Alt+1 to Alt+9, then Alt+0; there are no more digits.
    if (number <= 10) action->setShortcut(QKeySequence(Qt::ALT | Qt::Key(Qt::Key_0 + number++ % 10)));
    addAction(action);
  }
}

void ViewMenu::addPicture() {
  QAction* overlay = addAction(tr("Preview &Overlay"), QKeySequence(Qt::CTRL | Qt::Key_B));
  overlay->setToolTip(tr("Shows scene, exposure, time, samples and effects of the image over the preview"));
  QAction* noise = addAction(tr("Filter &Noise"), &m_preview, &widgets::PreviewWidget::setNoiseFiltered);
  noise->setToolTip(
      tr("Smooths the image while it has few samples. Measurements, rendered images and difference images are never "
         "filtered; Copy Image and the export of the preview as shown contain what the preview shows."));
  for (QAction* action : {overlay, noise}) action->setCheckable(true);
  connect(this, &QMenu::aboutToShow, this, [this, overlay, noise] {
    overlay->setChecked(m_preview.overlay()->statusWanted());
    noise->setChecked(m_preview.isNoiseFiltered());
  });
  connect(overlay, &QAction::triggered, this,
          [shown = m_preview.overlay()] { shown->setStatusWanted(!shown->statusWanted()); });
  m_pictureActions << addAction(tr("&Frame Object (F)"), &m_preview.input(), &widgets::PreviewInput::frameObject);
  m_pictureActions << addAction(tr("&Reset View (R)"), &m_preview.input(), &widgets::PreviewInput::resetView) << overlay
                   << noise;
  addSeparator();
  addAction(tr("&Brighter"), QKeySequence(Qt::CTRL | Qt::Key_BracketRight), this,
            [this] { changeExposure(m_preview.display().exposure + exposureStep); });
  addAction(tr("&Darker"), QKeySequence(Qt::CTRL | Qt::Key_BracketLeft), this,
            [this] { changeExposure(m_preview.display().exposure - exposureStep); });
  addAction(tr("Reset &Exposure"), QKeySequence(Qt::CTRL | Qt::Key_Backslash), this, [this] { changeExposure(0); });
}

void ViewMenu::addPictureActionsTo(QMenu& menu) {
  Q_EMIT aboutToShow();  // the marks of the actions
  menu.addActions(m_pictureActions);
}

void ViewMenu::changeExposure(double stops) { m_preview.setExposure(std::clamp(stops, darkest, brightest)); }

void ViewMenu::addToneMap(QMenu* menu) {
  auto* group = new QActionGroup(this);
  const std::pair<QString, ToneMap> entries[] = {{tr("&Clamp"), ToneMap::clamp}, {tr("&Filmic"), ToneMap::filmic}};
  for (const auto& [text, toneMap] : entries) {
    QAction* action = group->addAction(menu->addAction(text));
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, toneMap = toneMap] {
      widgets::DisplaySettings display = m_preview.display();
      display.toneMap = toneMap;
      m_preview.setDisplay(display);
    });
    connect(menu, &QMenu::aboutToShow, this,
            [this, action, toneMap = toneMap] { action->setChecked(m_preview.display().toneMap == toneMap); });
  }
}

void ViewMenu::addTheme(QMenu* menu, QSettings& settings) {
  auto* group = new QActionGroup(this);
  const std::pair<QString, Theme> entries[] = {
      {tr("&System"), Theme::system}, {tr("&Light"), Theme::light}, {tr("&Dark"), Theme::dark}};
  for (const auto& [text, theme] : entries) {
    QAction* action = group->addAction(menu->addAction(text));
    action->setCheckable(true);
    // Preferences change it too.
    const auto show = [&settings, action, theme = theme] {
      action->setChecked(themeByName(settings.value("theme").toString()) == theme);
    };
    connect(menu, &QMenu::aboutToShow, action, show);
    show();
    connect(action, &QAction::triggered, this, [&settings, theme = theme] {
      settings.setValue("theme", themeName(theme));
      applyTheme(*qApp, theme);
    });
  }
}

void ViewMenu::addWindow() {
  QAction* full = addAction(tr("F&ull Screen"), QKeySequence(Qt::Key_F11), this, [window = parentWidget()](bool on) {
    window->setWindowState(on ? window->windowState() | Qt::WindowFullScreen
                              : window->windowState() & ~Qt::WindowFullScreen);
  });
  full->setCheckable(true);
  addAction(tr("Reset Layou&t"), &m_docks, &DockLayout::reset);
}

}  // namespace gonio::app

#include "moc_view_menu.cpp"
