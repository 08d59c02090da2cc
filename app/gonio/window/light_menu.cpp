// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/light_menu.h"

#include <QActionGroup>
#include <QFileDialog>

#include "app/gonio/window/environment_controller.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

LightMenu::LightMenu(EnvironmentController& environment, widgets::PreviewWidget& preview, QWidget* window)
    : QMenu(tr("&Light"), window), m_environment(environment), m_preview(preview) {
  auto* group = new QActionGroup(this);
  add(tr("&Studio"), QStringLiteral("studio"), group);
  add(tr("S&ky"), QStringLiteral("sky"), group);
  add(tr("&Furnace"), QStringLiteral("furnace"), group);
  add(tr("&Directional Light"), {}, group, QKeySequence(Qt::CTRL | Qt::Key_L));
  addAction(tr("&Open Environment..."), this, &LightMenu::askForFile);
  addSeparator();
  addBackground();
}

void LightMenu::add(const QString& text, const QString& name, QActionGroup* group, const QKeySequence& key) {
  QAction* action = group->addAction(addAction(text, key, this, [this, name] { m_environment.open(name); }));
  action->setCheckable(true);
  connect(this, &QMenu::aboutToShow, this, [this, action, name] { action->setChecked(m_environment.name() == name); });
}

void LightMenu::addBackground() {
  QAction* background = addAction(tr("Show &Background"), this, [this](bool shown) {
    Scene scene = m_preview.scene();
    scene.showEnvironment = shown;
    m_preview.setScene(scene);
  });
  background->setCheckable(true);
  connect(this, &QMenu::aboutToShow, this, [this, background] {
    background->setChecked(m_preview.scene().showEnvironment);
    background->setEnabled(m_preview.scene().environment != nullptr);
  });
}

void LightMenu::askForFile() {
  const QString path = QFileDialog::getOpenFileName(parentWidget(), tr("Open Environment"), {},
                                                    tr("Environments (*.hdr *.exr);;All files (*)"));
  if (!path.isEmpty()) m_environment.open(path);
}

}  // namespace gonio::app

#include "moc_light_menu.cpp"
