// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/material_menu.h"

#include <QPushButton>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/comparison/comparison_controller.h"
#include "app/gonio/document/file_exports.h"
#include "app/gonio/document/material_files.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "app/gonio/study/fit_ranking_panel.h"
#include "app/gonio/window/dock_layout.h"
#include "core/materials/encode.h"
#include "core/materials/material.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

MaterialMenu::MaterialMenu(const Parts& parts, QWidget* window) : QMenu(tr("&Material"), window) {
  addFits(parts);
  addBlends(parts);
  QAction* acquire = addAction(tr("Ac&quire..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A), this,
                               [&docks = parts.docks, &acquisition = parts.acquisition] {
                                 docks.show(QStringLiteral("acquisition"));
                                 acquisition.startButton().setFocus();
                               });
  acquire->setToolTip(tr("Chooses directions to measure and reconstructs a material from a few measurements"));
  addCancel(parts);
}

void MaterialMenu::addFits(const Parts& parts) {
  QAction* fit =
      addAction(tr("&Fit"), QKeySequence(Qt::CTRL | Qt::Key_F5), &parts.controller, &DocumentController::fit);
  fit->setToolTip(tr("Fits the model in use to the measurement"));
  QAction* fitAll = addAction(tr("Fit &All"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F5), this,
                              [&docks = parts.docks, &ranking = parts.ranking] {
                                docks.show(QStringLiteral("models"));
                                ranking.fitAll();
                              });
  fitAll->setToolTip(tr("Fits every model and ranks them"));
  QAction* save = addAction(tr("&Save Fit..."), this, [this, &document = parts.document] { saveFit(document); });
  save->setToolTip(tr("Saves the fitted model, without the measurement, as a table"));
  const auto update = [&document = parts.document, fit, fitAll, save] {
    for (QAction* action : {fit, fitAll}) action->setEnabled(document.material() != nullptr);
    save->setEnabled(document.active<editing::DifferentialEdit>() != nullptr);
  };
  connect(&parts.document, &Document::materialChanged, this, update);
  connect(&parts.document, &Document::stateChanged, this, update);
  update();
}

void MaterialMenu::saveFit(const Document& document) {
  const auto* edit = document.active<editing::DifferentialEdit>();
  if (!edit) return;
  const models::Model* model = edit->model;
  const QString suffix = tableSuffix();
  Q_EMIT saveRequested({tr("Save Fit"), tr("%1, %2 fit").arg(document.name(), widgets::toQString(model->spec().name)),
                        tr("MERL file (*%1)").arg(suffix), suffix,
                        [model, fitted = edit->fitted, name = document.name().toStdString()](
                            const std::filesystem::path& path, const TaskControl& control) {
                          materials::writeMaterial(materials::unedited(name, model->instantiate(fitted)), path, {},
                                                   control);
                        }});
}

void MaterialMenu::addBlends(const Parts& parts) {
  QAction* interpolate = addAction(tr("&Interpolate..."), QKeySequence(Qt::CTRL | Qt::Key_I), this,
                                   [&docks = parts.docks, &interpolation = parts.interpolation] {
                                     docks.show(QStringLiteral("interpolation"));
                                     interpolation.begin();
                                   });
  interpolate->setToolTip(
      tr("Blends the open material with others; the open material is put in slot A if this slot is empty"));
  QAction* open = addAction(tr("&Open Blend as Material"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_K),
                            &parts.interpolation, &InterpolationPanel::openAsMaterial);
  open->setToolTip(tr("Opens the blend of the Interpolation panel as a material; Undo restores the previous material"));
}

void MaterialMenu::addCancel(const Parts& parts) {
  // What is shown instead of the material goes first: that loses no work.
  QAction* cancel = addAction(tr("&Cancel"), QKeySequence(Qt::Key_Escape), this,
                              [&tasks = parts.tasks, &comparison = parts.comparison] {
                                if (comparison.isReplaced()) return comparison.dismissStandIn();
                                tasks.cancelTopmost();
                              });
  cancel->setToolTip(
      tr("Shows the open material if the preview shows something else; otherwise stops the most recent task"));
  const auto update = [&tasks = parts.tasks, &comparison = parts.comparison, cancel] {
    const auto task = tasks.topmost();
    cancel->setEnabled(comparison.isReplaced() || (task && !task->quiet));
  };
  connect(&parts.tasks, &BackgroundTasks::changed, this, update);
  connect(&parts.comparison, &ComparisonController::subjectsChanged, this, update);
  update();
}

}  // namespace gonio::app

#include "moc_material_menu.cpp"
