// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/main_window.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QStatusBar>
#include <QUndoView>
#include <QVBoxLayout>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/comparison/comparison_panel.h"
#include "app/gonio/document/edit_steps.h"
#include "app/gonio/factors/factor_curves_panel.h"
#include "app/gonio/inspector/representation_panel.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "app/gonio/library/thumbnail.h"
#include "app/gonio/scene/scene_panel.h"
#include "app/gonio/study/fit_ranking_panel.h"
#include "app/gonio/study/study_panel.h"
#include "app/gonio/window/analyse_menu.h"
#include "app/gonio/window/dropped_files.h"
#include "app/gonio/window/edit_menu.h"
#include "app/gonio/window/file_menu.h"
#include "app/gonio/window/help_menu.h"
#include "app/gonio/window/material_menu.h"
#include "app/gonio/window/view_menu.h"
#include "app/gonio/window/view_state.h"
#include "core/rendering/environment_file.h"
#include "widgets/library/library_view.h"
#include "widgets/library/material_drag.h"
#include "widgets/panels/drop_overlay.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/progress_strip.h"
#include "widgets/parameters/parameter_text.h"
#include "widgets/preview/comparison_bar.h"
#include "widgets/preview/gl/textures.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {

constexpr QSize firstSize(1440, 900), smallestSize(960, 600);

LibraryController::LookMaker lookMaker() {
  return [folder = thumbnailCacheFolder()](const QString& id, const TaskControl& control) {
    return materialLook(id, folder, control);
  };
}

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      m_recentFiles(m_settings),
      m_controller(m_document, m_tasks),
      m_libraryController(m_tasks, lookMaker()),
      m_autosave(Autosave::defaultDataFolder(),
                 [this]() -> std::optional<editing::EditDocument> {
                   if (!m_document.isModified()) return std::nullopt;
                   editing::EditDocument stored = m_document.toEditDocument();
                   stored.view = viewToJson(*m_preview);
                   return stored;
                 }),
      m_preview(new widgets::PreviewWidget),
      m_libraryView(new widgets::LibraryView(&m_libraryController.model())),
      m_inspector(new Inspector(m_document, m_controller, m_tasks)),
      m_comparisonBar(new widgets::ComparisonBar),
      m_comparison(new ComparisonController(m_document, m_tasks, *m_preview, *m_comparisonBar, this)),
      m_comparisonPanel(new ComparisonPanel(*m_comparison, m_tasks)),
      m_plots(new PlotsPanel(m_document, m_tasks)),
      m_factors(new FactorCurvesPanel(m_document, m_tasks)),
      m_ranking(new FitRankingPanel(m_document, m_controller, m_tasks)),
      m_interpolation(new InterpolationPanel(m_document, m_tasks)),
      m_study(new StudyPanel(m_document, m_tasks)),
      m_scenePanel(new ScenePanel(*m_preview, m_document, m_tasks)),
      m_acquisition(new AcquisitionPanel(m_document, m_tasks)),
      m_messages(new widgets::MessageBar),
      m_progress(new widgets::ProgressStrip),
      m_dropOverlay(nullptr),
      m_history(new QUndoView(&m_document.history())) {
  setAttribute(Qt::WA_DeleteOnClose);
  setAcceptDrops(true);
  setMinimumSize(smallestSize);
  resize(firstSize);
  buildCentre();
  buildDocks();
  buildStatusBar();
  new FileMenu(*this);
  new EditMenu(*this);
  new ViewMenu(*this);
  new MaterialMenu(*this);
  new AnalyseMenu(*this);
  new HelpMenu(*this);
  connectDocument();
  connectController();
  m_dropOverlay = new widgets::DropOverlay(this);
  m_defaultLayout = saveState(layoutVersion);
  restoreSettings();
  showTitle();
  showRepresentation();
}

MainWindow::~MainWindow() = default;

void MainWindow::connectDocument() {
  connect(&m_document, &Document::titleChanged, this, &MainWindow::showTitle);
  connect(&m_document, &Document::materialChanged, this, [this] { m_messages->hide(); });
  connect(&m_document, &Document::materialReplaced, this, [this] {
    m_autosave.setDocumentPath(m_document.path());
    m_autosave.update();
  });
  connect(m_interpolation, &InterpolationPanel::subjectChanged, this, [this] {
    m_comparison->setStandIn(StandIn::blend, m_interpolation->subject(), m_interpolation->description());
  });
  connect(m_study, &StudyPanel::subjectChanged, this,
          [this] { m_comparison->setStandIn(StandIn::representation, m_study->subject(), m_study->shownName()); });
  connect(m_study, &StudyPanel::taken, this, &MainWindow::takeRepresentation);
  connect(m_inspector->representation(), &RepresentationPanel::shownChanged, this,
          [this] { m_comparison->setCode(m_inspector->representation()->shown()); });
  connect(m_comparison, &ComparisonController::subjectsChanged, this, &MainWindow::showRepresentation);
  connect(m_comparison, &ComparisonController::comparisonChanged, this, &MainWindow::showRepresentation);
}

void MainWindow::connectController() {
  connect(&m_controller, &DocumentController::opened, this, [this](const QString& path) {
    m_autosave.setDocumentPath(m_document.path());
    m_autosave.update();
    if (!path.isEmpty()) m_recentFiles.add(path);
    const LoadedMaterialPtr& material = m_document.material();
    m_libraryView->selectItem(QString::fromStdString(material->material.source.path.string()));
  });
  connect(&m_controller, &DocumentController::recovered, this,
          [this](const QString& autosavePath) { Autosave::forget(Autosave::defaultDataFolder(), autosavePath); });
  connect(&m_controller, &DocumentController::saved, this, [this](const QString& path) {
    m_autosave.setDocumentPath(path);
    m_recentFiles.add(path);
    statusBar()->showMessage(tr("Saved %1").arg(path), 4000);
  });
  connect(&m_controller, &DocumentController::exported, this,
          [this](const QString& path) { statusBar()->showMessage(tr("Wrote %1").arg(path), 6000); });
  connect(&m_controller, &DocumentController::viewRestored, this, [this](const nlohmann::json& view) {
    const auto restore = [this, view] {
      restoreView(*m_preview, view);
      const auto& own = m_preview->scene().environment;
      const auto environment = environmentOf(view);
      if (environment && environment->toStdString() != (own ? own->name() : "")) setEnvironment(*environment);
    };
    m_scenePanel->open(sceneNameOf(view), restore);
  });
  connect(&m_controller, &DocumentController::failed, this, &MainWindow::showFailure);
  connect(m_comparison, &ComparisonController::failed, this, &MainWindow::showFailure);
  connect(m_factors, &FactorCurvesPanel::failed, this, &MainWindow::showFailure);
  connect(m_inspector, &Inspector::factorEditWanted, this, [this] {
    showDock(QStringLiteral("factors"));
    m_factors->addEdit();
  });
  connect(m_ranking, &FitRankingPanel::failed, this, &MainWindow::showFailure);
  connect(m_interpolation, &InterpolationPanel::failed, this, &MainWindow::showFailure);
  connect(m_study, &StudyPanel::failed, this, &MainWindow::showFailure);
  connect(m_study, &StudyPanel::exported, &m_controller, &DocumentController::exported);
  connect(m_scenePanel, &ScenePanel::failed, this, &MainWindow::showFailure);
  connect(&m_controller, &DocumentController::warned, m_messages, &widgets::MessageBar::showMessage);
  connect(&m_controller, &DocumentController::proposalOffered, m_messages, &widgets::MessageBar::showProposal);
  connect(m_messages, &widgets::MessageBar::applied, &m_controller, &DocumentController::applyProposal);
  connect(m_messages, &widgets::MessageBar::discarded, &m_controller, &DocumentController::discardProposal);
}

void MainWindow::showFailure(const QString& title, const QString& text) {
  auto* box = new QMessageBox(QMessageBox::Warning, title, title, QMessageBox::Ok, this);
  box->setInformativeText(text);
  box->setTextFormat(Qt::PlainText);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

void MainWindow::showTitle() {
  setWindowTitle(tr("%1[*] - Gonio").arg(m_document.name()));
  setWindowModified(m_document.isModified());
}

void MainWindow::showProgress() {
  const auto task = m_tasks.topmost();
  if (task)
    m_progress->showProgress(task->title, task->share, !task->quiet);
  else
    m_progress->clear();
}

void MainWindow::showRepresentation() {
  const LoadedMaterialPtr& material = m_document.material();
  const auto standIn = m_comparison->standIn();
  if (!material && !standIn) return m_representation->setText(tr("Nothing open"));
  if (m_preview->isComparing()) {
    const auto sides = m_comparison->sides();
    return m_representation->setText(tr("%1 | %2").arg(m_comparison->name(sides[0]), m_comparison->name(sides[1])));
  }
  if (standIn == StandIn::blend) return m_representation->setText(tr("Blend: %1").arg(m_comparison->standInName()));
  if (standIn)
    return m_representation->setText(tr("In the material's place, without edits: %1").arg(m_comparison->standInName()));
  const MaterialCode* code = m_comparison->code();
  QString text = code ? tr("Code of %1 coefficients").arg(code->encoded.code.coefficients())
                      : tr("%1 table").arg(QString::fromStdString(material->material.source.format));
  QStringList parts{text};
  const editing::EditList& edits = m_document.edits();
  for (int i = 0; i < int(edits.size()); ++i)
    if (!edits[std::size_t(i)].isIdentity()) parts << editName(edits, i);
  m_representation->setText(parts.join(QStringLiteral(" + ")));
}

void MainWindow::takeRepresentation(const study::Representation& representation) {
  // What has a place of its own goes there; the rest stays in the preview.
  if (representation.family == study::RepresentationFamily::fit) {
    m_study->show(-1);
    m_controller.chooseModel(models::findModel(representation.id));
  } else if (representation.family == study::RepresentationFamily::code) {
    m_study->show(-1);
    m_inspector->unfoldRepresentation();
    m_inspector->representation()->setCoefficients(std::size_t(representation.budget));
    m_inspector->representation()->showEncoded().setChecked(true);
  }
}

void MainWindow::open(const QString& path) {
  if (mayDiscard()) m_controller.open(path);
}

void MainWindow::setEnvironment(const QString& nameOrPath) {
  m_tasks.run<std::shared_ptr<const EnvironmentMap>>(
      {tr("Reading the environment %1").arg(nameOrPath.section('/', -1)), QStringLiteral("environment")},
      [nameOrPath](const TaskControl&) -> std::shared_ptr<const EnvironmentMap> {
        if (nameOrPath.isEmpty()) return nullptr;
        const auto environment = openEnvironment(nameOrPath.toStdString());
        widgets::environmentTexels(environment);  // so that the preview need not wait for them
        return environment;
      },
      [this](const std::shared_ptr<const EnvironmentMap>& environment) { m_preview->setEnvironment(environment); },
      [this](const QString& error) { Q_EMIT m_controller.failed(tr("Cannot read the environment"), error); });
}

bool MainWindow::mayDiscard() {
  if (!m_document.isModified()) return true;
  const auto answer =
      QMessageBox::question(this, tr("Unsaved changes"), tr("Save the changes of %1 first?").arg(m_document.name()),
                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

bool MainWindow::isSettled() const {
  const auto task = m_tasks.topmost();
  return (!task || task->quiet) && m_inspector->isSettled() && m_comparisonPanel->isSettled() && m_plots->isSettled() &&
         m_factors->isSettled() && m_interpolation->isSettled() && m_acquisition->isSettled() &&
         m_libraryController.isVisibleComplete() && (!m_preview->hasMaterial() || m_preview->converged());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayDiscard()) return event->ignore();
  m_autosave.discard();
  saveSettings();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QString file = widgets::draggedFile(event->mimeData());
  if (file.isEmpty()) return;
  m_dropOverlay->announce(dropDescription(file, event->modifiers() & Qt::ControlModifier));
  event->acceptProposedAction();
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) { m_dropOverlay->hide(); }

void MainWindow::dropEvent(QDropEvent* event) {
  m_dropOverlay->hide();
  const QString file = widgets::draggedFile(event->mimeData());
  if (isPicture(file))
    setEnvironment(file);
  else if (isScene(file))
    m_scenePanel->open(file);
  else if (!file.isEmpty() && event->modifiers() & Qt::ControlModifier)
    m_comparison->openReference(file);
  else if (!file.isEmpty())
    open(file);
  event->acceptProposedAction();
}

}  // namespace gonio::app

#include "moc_main_window.cpp"
