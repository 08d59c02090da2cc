// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Where the parts of the window stand.
#include <QDockWidget>
#include <QLabel>
#include <QListView>
#include <QStatusBar>
#include <QUndoView>
#include <QVBoxLayout>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/comparison/comparison_panel.h"
#include "app/gonio/comparison/reference_dialog.h"
#include "app/gonio/document/material_files.h"
#include "app/gonio/factors/factor_curves_panel.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "app/gonio/scene/scene_panel.h"
#include "app/gonio/study/fit_ranking_panel.h"
#include "app/gonio/study/study_panel.h"
#include "app/gonio/window/main_window.h"
#include "widgets/library/library_model.h"
#include "widgets/library/library_view.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/plausibility_badges.h"
#include "widgets/panels/progress_strip.h"
#include "widgets/preview/comparison_bar.h"
#include "widgets/preview/preview_overlay.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {
constexpr int bottomDockLines = 22, acquisitionDockLines = 30;
}

void MainWindow::buildCentre() {
  auto* centre = new QWidget;
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_messages);
  layout->addWidget(m_comparisonBar);
  layout->addWidget(m_preview, 1);
  setCentralWidget(centre);
  m_preview->setToneMap(ToneMap::filmic);
}

QDockWidget* MainWindow::addDock(const QString& title, const QString& name, QWidget* content, Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(content);
  addDockWidget(area, dock);
  m_docks << dock;
  return dock;
}

void MainWindow::buildDocks() {
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks | GroupedDragging);
  QDockWidget* library = addDock(tr("Library"), "library", m_libraryView, Qt::LeftDockWidgetArea);
  QDockWidget* inspector = addDock(tr("Inspector"), "inspector", m_inspector, Qt::RightDockWidgetArea);
  m_history->setEmptyLabel(tr("Opened"));
  m_history->setAccessibleName(tr("History"));
  addDock(tr("History"), "history", m_history, Qt::RightDockWidgetArea)->hide();
  buildBottomDocks();
  const int em = fontMetrics().height();
  resizeDocks({library, inspector}, {em * 27, em * 28}, Qt::Horizontal);
  m_libraryView->setEmptyText(tr("There are no materials in this folder (%1).\nFile > Bundled Library shows the "
                                 "materials that come with Gonio.")
                                  .arg(materialFilePatterns().join(' ')));
  connect(&m_libraryController, &LibraryController::titleChanged, m_libraryView, &widgets::LibraryView::setTitle);
  connect(m_libraryView, &widgets::LibraryView::visibleIdsChanged, &m_libraryController,
          &LibraryController::setVisible);
  connect(m_libraryView, &widgets::LibraryView::openRequested, this, &MainWindow::open);
  connect(m_libraryView, &widgets::LibraryView::referenceRequested, m_comparison, &ComparisonController::openReference);
}

void MainWindow::buildBottomDocks() {
  QDockWidget* plots = addDock(tr("Plots"), "plots", m_plots, Qt::BottomDockWidgetArea);
  QDockWidget* comparison = addDock(tr("Comparison"), "comparison", m_comparisonPanel, Qt::BottomDockWidgetArea);
  QDockWidget* models = addDock(tr("Models"), "models", m_ranking, Qt::BottomDockWidgetArea);
  QDockWidget* factors = addDock(tr("Factor curves"), "factors", m_factors, Qt::BottomDockWidgetArea);
  QDockWidget* interpolation = addDock(tr("Interpolation"), "interpolation", m_interpolation, Qt::BottomDockWidgetArea);
  QDockWidget* study = addDock(tr("Accuracy against time"), "study", m_study, Qt::BottomDockWidgetArea);
  QDockWidget* scene = addDock(tr("Scene"), "scene", m_scenePanel, Qt::BottomDockWidgetArea);
  tabifyDockWidget(plots, comparison);
  tabifyDockWidget(comparison, models);
  tabifyDockWidget(models, factors);
  tabifyDockWidget(factors, interpolation);
  tabifyDockWidget(interpolation, study);
  QDockWidget* acquisition = addDock(tr("Acquisition"), "acquisition", m_acquisition, Qt::BottomDockWidgetArea);
  tabifyDockWidget(study, scene);
  tabifyDockWidget(scene, acquisition);
  for (QDockWidget* dock : {plots, comparison, models, factors, interpolation, study, scene, acquisition}) dock->hide();
  connectAcquisition();
  connect(m_libraryView, &widgets::LibraryView::interpolationRequested, this, [this](const QString& id) {
    showDock(QStringLiteral("interpolation"));
    m_interpolation->take(id);
  });
  connect(m_plots, &PlotsPanel::pickingToggled, m_preview, &widgets::PreviewWidget::setPicking);
  connect(m_preview, &widgets::PreviewWidget::polarAnglePicked, m_plots, &PlotsPanel::setThetaI);
  connect(m_inspector->plausibility(), &widgets::PlausibilityBadges::showRequested, m_plots,
          [this](const QString& check, double theta) {
            m_plots->showAt(check == "energy" ? PlotKind::albedo : PlotKind::cartesian, theta);
          });
  connect(m_plots, &PlotsPanel::exported, &m_controller, &DocumentController::exported);
  connect(m_plots, &PlotsPanel::failed, &m_controller, &DocumentController::failed);
}

void MainWindow::connectAcquisition() {
  m_acquisition->controls().setShownIds([this] {
    const QAbstractItemModel& shown = *m_libraryView->list()->model();
    QStringList ids;
    for (int row = 0; row < shown.rowCount(); ++row)
      ids << shown.index(row, 0).data(widgets::LibraryModel::IdRole).toString();
    return ids;
  });
  connect(m_acquisition, &AcquisitionPanel::subjectWanted, this, [this] {
    auto* dialog = new ReferenceDialog(m_libraryController.model(), this);
    dialog->setWindowTitle(tr("Material to Measure"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ReferenceDialog::chosen, m_acquisition, &AcquisitionPanel::measure);
    dialog->open();
  });
  connect(m_acquisition, &AcquisitionPanel::exported, &m_controller, &DocumentController::exported);
  connect(m_acquisition, &AcquisitionPanel::failed, this, &MainWindow::showFailure);
}

void MainWindow::showAcquisitionLayout() {
  resetLayout();
  for (const auto& name : {QStringLiteral("library"), QStringLiteral("inspector")}) showDock(name, false);
  showDock(QStringLiteral("acquisition"));
  for (QDockWidget* dock : m_docks)
    if (dock->widget() == m_acquisition)
      resizeDocks({dock}, {acquisitionDockLines * fontMetrics().height()}, Qt::Vertical);
}

void MainWindow::showDock(const QString& name, bool shown) {
  for (QDockWidget* dock : m_docks) {
    if (dock->objectName() != name) continue;
    const bool wasHidden = dock->isHidden();
    dock->setVisible(shown);
    if (!shown) return;
    dock->raise();
    if (wasHidden && dockWidgetArea(dock) == Qt::BottomDockWidgetArea)
      resizeDocks({dock}, {bottomDockLines * fontMetrics().height()}, Qt::Vertical);
  }
}

void MainWindow::buildStatusBar() {
  const auto permanent = [this](const QString& toolTip) {
    auto* label = new QLabel;
    label->setToolTip(toolTip);
    label->setContentsMargins(8, 0, 8, 0);
    statusBar()->addPermanentWidget(label);
    return label;
  };
  // The bar of progress comes and goes: a status bar that grows with it would resize the preview, which starts anew.
  statusBar()->setMinimumHeight(2 * fontMetrics().height());
  m_progress->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  statusBar()->addWidget(m_progress, 1);
  m_representation = permanent(tr("What the preview shows"));
  m_samples = permanent(tr("Light samples of each pixel so far"));
  m_frameTime = permanent(tr("Time of the last frame"));
  connect(m_preview, &widgets::PreviewWidget::frameRendered, this, [this](double milliseconds, int samples) {
    m_frameTime->setText(tr("%1 ms").arg(milliseconds, 0, 'f', 1));
    m_samples->setText(widgets::samplesText(samples));
  });
  connect(m_preview, &widgets::PreviewWidget::failed, m_messages, &widgets::MessageBar::showMessage);
  connect(&m_tasks, &BackgroundTasks::changed, this, &MainWindow::showProgress);
  connect(m_progress, &widgets::ProgressStrip::cancelRequested, &m_tasks, &BackgroundTasks::cancelTopmost);
}

}  // namespace gonio::app
