// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/view_menu.h"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QMenuBar>

#include "app/gonio/window/main_window.h"
#include "app/gonio/window/theme.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {
constexpr double exposureStep = 0.5, darkest = -10, brightest = 10;
}

ViewMenu::ViewMenu(MainWindow& window) : QObject(&window), m_window(window) {
  QMenu* menu = window.menuBar()->addMenu(tr("&View"));
  addLayouts(menu->addMenu(tr("La&youts")));
  addDocks(menu);
  menu->addSeparator();
  addPicture(menu);
  addToneMap(menu->addMenu(tr("&Tone Map")));
  addLight(menu);
  menu->addSeparator();
  addTheme(menu->addMenu(tr("T&heme")));
  addWindow(menu);
}

void ViewMenu::addLayouts(QMenu* menu) {
  menu->addAction(tr("&Edit"), QKeySequence(Qt::CTRL | Qt::Key_1), this, [this] { m_window.resetLayout(); });
  menu->addAction(tr("&Compare"), QKeySequence(Qt::CTRL | Qt::Key_2), this, [this] {
    m_window.resetLayout();
    m_window.showDock(QStringLiteral("library"), false);
    m_window.showDock(QStringLiteral("comparison"));
    ComparisonController& comparison = m_window.comparison();
    if (comparison.comparison().mode == widgets::CompareMode::off) comparison.toggle();
  });
  menu->addAction(tr("&Analyse"), QKeySequence(Qt::CTRL | Qt::Key_3), this, [this] {
    m_window.resetLayout();
    m_window.showDock(QStringLiteral("models"));
    m_window.showDock(QStringLiteral("plots"));
  });
  menu->addAction(tr("Ac&quire"), QKeySequence(Qt::CTRL | Qt::Key_4), &m_window, &MainWindow::showAcquisitionLayout);
}

void ViewMenu::addDocks(QMenu* menu) {
  int number = 1;
  for (QDockWidget* dock : m_window.docks()) {
    QAction* action = dock->toggleViewAction();
    // Alt+1 to Alt+9, then Alt+0; there are no more digits.
    if (number <= 10) action->setShortcut(QKeySequence(Qt::ALT | Qt::Key(Qt::Key_0 + number++ % 10)));
    menu->addAction(action);
  }
}

void ViewMenu::addPicture(QMenu* menu) {
  widgets::PreviewWidget& preview = m_window.preview();
  QAction* overlay = menu->addAction(tr("&Overlay"), QKeySequence(Qt::CTRL | Qt::Key_B));
  overlay->setCheckable(true);
  connect(menu, &QMenu::aboutToShow, this, [&preview, overlay] { overlay->setChecked(preview.overlayVisible()); });
  connect(overlay, &QAction::triggered, this, [&preview] { preview.setOverlayVisible(!preview.overlayVisible()); });
  menu->addAction(tr("&Frame Sphere"), &preview, &widgets::PreviewWidget::frameObject);
  menu->addAction(tr("&Reset View"), &preview, &widgets::PreviewWidget::resetView);
  menu->addSeparator();
  menu->addAction(tr("&Brighter"), QKeySequence(Qt::CTRL | Qt::Key_BracketRight), this,
                  [this] { changeExposure(m_window.preview().exposure() + exposureStep); });
  menu->addAction(tr("&Darker"), QKeySequence(Qt::CTRL | Qt::Key_BracketLeft), this,
                  [this] { changeExposure(m_window.preview().exposure() - exposureStep); });
  menu->addAction(tr("Reset &Exposure"), QKeySequence(Qt::CTRL | Qt::Key_Backslash), this,
                  [this] { changeExposure(0); });
}

void ViewMenu::changeExposure(double stops) { m_window.preview().setExposure(std::clamp(stops, darkest, brightest)); }

void ViewMenu::addToneMap(QMenu* menu) {
  auto* group = new QActionGroup(this);
  const std::pair<QString, ToneMap> entries[] = {{tr("&Clamp"), ToneMap::clamp}, {tr("&Filmic"), ToneMap::filmic}};
  for (const auto& [text, toneMap] : entries) {
    QAction* action = group->addAction(menu->addAction(text));
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, toneMap = toneMap] { m_window.preview().setToneMap(toneMap); });
    connect(menu, &QMenu::aboutToShow, this,
            [this, action, toneMap = toneMap] { action->setChecked(m_window.preview().toneMap() == toneMap); });
  }
}

void ViewMenu::addLight(QMenu* menu) {
  QMenu* light = menu->addMenu(tr("&Light"));
  auto* group = new QActionGroup(this);
  const auto add = [&](const QString& text, const QString& name, const QKeySequence& key) {
    QAction* action =
        group->addAction(light->addAction(text, key, this, [this, name] { m_window.setEnvironment(name); }));
    action->setCheckable(true);
    connect(light, &QMenu::aboutToShow, this, [this, action, name] {
      const auto& environment = m_window.preview().scene().environment;
      action->setChecked(environment ? environment->name() == name.toStdString() : name.isEmpty());
    });
  };
  add(tr("&Studio"), QStringLiteral("studio"), {});
  add(tr("S&ky"), QStringLiteral("sky"), {});
  add(tr("&Furnace"), QStringLiteral("furnace"), {});
  add(tr("&Directional Light"), {}, QKeySequence(Qt::CTRL | Qt::Key_L));
  light->addAction(tr("&Open Environment..."), this, [this] {
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Open Environment"), {},
                                                      tr("Environments (*.hdr *.exr);;All files (*)"));
    if (!path.isEmpty()) m_window.setEnvironment(path);
  });
  light->addSeparator();
  QAction* background = light->addAction(tr("Show &Background"), this, [this](bool shown) {
    Scene scene = m_window.preview().scene();
    scene.showEnvironment = shown;
    m_window.preview().setScene(scene);
  });
  background->setCheckable(true);
  connect(light, &QMenu::aboutToShow, this, [this, background] {
    background->setChecked(m_window.preview().scene().showEnvironment);
    background->setEnabled(m_window.preview().scene().environment != nullptr);
  });
}

void ViewMenu::addTheme(QMenu* menu) {
  auto* group = new QActionGroup(this);
  const Theme current = themeByName(m_window.settings().value("theme").toString());
  const std::pair<QString, Theme> entries[] = {
      {tr("&System"), Theme::system}, {tr("&Light"), Theme::light}, {tr("&Dark"), Theme::dark}};
  for (const auto& [text, theme] : entries) {
    QAction* action = group->addAction(menu->addAction(text));
    action->setCheckable(true);
    action->setChecked(theme == current);
    connect(action, &QAction::triggered, this, [this, theme = theme] {
      m_window.settings().setValue("theme", themeName(theme));
      applyTheme(*qApp, theme);
    });
  }
}

void ViewMenu::addWindow(QMenu* menu) {
  QAction* full = menu->addAction(tr("F&ull Screen"), QKeySequence(Qt::Key_F11), this, [this](bool on) {
    m_window.setWindowState(on ? m_window.windowState() | Qt::WindowFullScreen
                               : m_window.windowState() & ~Qt::WindowFullScreen);
  });
  full->setCheckable(true);
  menu->addAction(tr("Reset Layou&t"), &m_window, &MainWindow::resetLayout);
}

}  // namespace gonio::app

#include "moc_view_menu.cpp"
