// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/material_menu.h"

#include <QMenuBar>
#include <QPushButton>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "app/gonio/study/fit_ranking_panel.h"
#include "app/gonio/window/main_window.h"

namespace gonio::app {

MaterialMenu::MaterialMenu(MainWindow& window) : QObject(&window) {
  QMenu* menu = window.menuBar()->addMenu(tr("&Material"));
  QAction* fit =
      menu->addAction(tr("&Fit"), QKeySequence(Qt::CTRL | Qt::Key_F5), &window.controller(), &DocumentController::fit);
  fit->setToolTip(tr("Fits the model in use to the measurement"));
  QAction* fitAll = menu->addAction(tr("Fit &All"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F5), this, [&window] {
    window.showDock(QStringLiteral("models"));
    window.ranking().fitAll();
  });
  fitAll->setToolTip(tr("Fits every model and ranks them"));
  QAction* interpolate = menu->addAction(tr("&Interpolate..."), QKeySequence(Qt::CTRL | Qt::Key_I), this, [&window] {
    window.showDock(QStringLiteral("interpolation"));
    window.interpolation().begin();
  });
  interpolate->setToolTip(tr("Blends the open material with others; it becomes A if A is empty"));
  QAction* keep = menu->addAction(tr("&Keep Blend as Material"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_K),
                                  &window.interpolation(), &InterpolationPanel::keep);
  keep->setToolTip(tr("The blend of the Interpolation dock becomes the open material; undo brings back what was open"));
  QAction* acquire =
      menu->addAction(tr("Ac&quire..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A), this, [&window] {
        window.showDock(QStringLiteral("acquisition"));
        window.acquisition().startButton().setFocus();
      });
  acquire->setToolTip(tr("Where to measure a material, and the whole material from a few measurements"));
  QAction* cancel =
      menu->addAction(tr("&Cancel"), QKeySequence(Qt::Key_Escape), &window.tasks(), &BackgroundTasks::cancelTopmost);
  cancel->setToolTip(tr("Stops the newest work in progress"));
  const auto update = [&window, fit, fitAll, cancel] {
    fit->setEnabled(window.document().material() != nullptr);
    fitAll->setEnabled(fit->isEnabled());
    const auto task = window.tasks().topmost();
    cancel->setEnabled(task && !task->quiet);
  };
  connect(&window.document(), &Document::materialChanged, this, update);
  connect(&window.tasks(), &BackgroundTasks::changed, this, update);
  update();
}

}  // namespace gonio::app

#include "moc_material_menu.cpp"
