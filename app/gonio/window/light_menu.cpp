// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/light_menu.h"

#include <QActionGroup>
#include <QFileDialog>
#include <utility>

#include "app/gonio/scene/environment_controller.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/preview/preview_content.h"

namespace gonio::app {

LightMenu::LightMenu(EnvironmentController& environment, widgets::PreviewContent& preview, QWidget* window)
    : QMenu(tr("&Light"), window), m_environment(environment), m_preview(preview), m_group(new QActionGroup(this)) {
  addOwn();
  add(tr("&Studio"), QStringLiteral("studio"));
  add(tr("S&ky"), QStringLiteral("sky"));
  add(tr("&Furnace"), QStringLiteral("furnace"));
  add(tr("&Distant Light"), {}, QKeySequence(Qt::CTRL | Qt::Key_L));
  addSeparator();
  m_afterRecent = addAction(tr("&Open Environment..."), this, &LightMenu::askForFile);
  addSeparator();
  addBackground();
  connect(this, &QMenu::aboutToShow, this, &LightMenu::showRecent);
}

void LightMenu::add(const QString& text, const QString& name, const QKeySequence& key) {
  QAction* action = m_group->addAction(addAction(text, key, this, [this, name] { m_environment.open(name); }));
  action->setCheckable(true);
  connect(this, &QMenu::aboutToShow, action,
          [this, action, name] { action->setChecked(!m_environment.isFromScene() && m_environment.name() == name); });
}

void LightMenu::addOwn() {
  QAction* own =
      m_group->addAction(addAction(tr("From S&cene"), &m_environment, &EnvironmentController::useSceneEnvironment));
  own->setCheckable(true);
  own->setToolTip(tr("Uses the light of the scene; a light chosen below stays when the scene changes"));
  connect(this, &QMenu::aboutToShow, own, [this, own] { own->setChecked(m_environment.isFromScene()); });
}

void LightMenu::showRecent() {
  for (QAction* action : std::exchange(m_recent, {})) delete action;
  const QStringList paths = m_environment.recent();
  const QString current = m_environment.isFromScene() ? QString() : m_environment.name();
  for (const QString& path : paths) {
    QAction* action = new QAction(widgets::menuText(path.section('/', -1)), this);
    action->setToolTip(path);
    action->setCheckable(true);
    action->setChecked(path == current);
    connect(action, &QAction::triggered, this, [this, path] { m_environment.open(path); });
    m_group->addAction(action);
    insertAction(m_afterRecent, action);
    m_recent << action;
  }
  setToolTipsVisible(true);
}

void LightMenu::addBackground() {
  QAction* background = addAction(tr("Show En&vironment"), this, [this](bool shown) {
    m_preview.setBackground(shown, m_preview.scene().blurBackground);
  });
  QAction* blur = addAction(tr("Bl&ur Environment"), this,
                            [this](bool on) { m_preview.setBackground(on || m_preview.scene().showEnvironment, on); });
  for (QAction* action : {background, blur}) action->setCheckable(true);
  connect(this, &QMenu::aboutToShow, this, [this, background, blur] {
    const Scene& scene = m_preview.scene();
    background->setChecked(scene.showEnvironment);
    blur->setChecked(scene.showEnvironment && scene.blurBackground);
    for (QAction* action : {background, blur}) action->setEnabled(scene.environment != nullptr);
  });
}

void LightMenu::askForFile() {
  const QString purpose = QStringLiteral("environment");
  const QString path =
      QFileDialog::getOpenFileName(parentWidget(), tr("Open Environment"), widgets::dialogFolder(purpose),
                                   tr("Environments (*.hdr *.exr);;All files (*)"));
  widgets::rememberDialogFolder(purpose, path);
  if (!path.isEmpty()) m_environment.open(path);
}

}  // namespace gonio::app

#include "moc_light_menu.cpp"
