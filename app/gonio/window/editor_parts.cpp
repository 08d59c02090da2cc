// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/editor_parts.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QListView>
#include <utility>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/acquisition/photograph_panel.h"
#include "app/gonio/comparison/comparison_panel.h"
#include "app/gonio/document/material_files.h"
#include "app/gonio/factors/factor_curves_panel.h"
#include "app/gonio/inspector/highlight_drag.h"
#include "app/gonio/inspector/inspector.h"
#include "app/gonio/inspector/representation_panel.h"
#include "app/gonio/inspector/wavelength_panel.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "app/gonio/library/thumbnail.h"
#include "app/gonio/matching/reference_panel.h"
#include "app/gonio/plots/plots_panel.h"
#include "app/gonio/scene/scene_panel.h"
#include "app/gonio/scene/view_strip.h"
#include "app/gonio/study/study_window.h"
#include "widgets/library/library_selection.h"
#include "widgets/library/library_view.h"
#include "widgets/library/quick_look.h"
#include "widgets/panels/plausibility_badges.h"
#include "widgets/preview/comparison_bar.h"
#include "widgets/preview/preview_overlay.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {

const QString libraryKey = QStringLiteral("library/folder"), tileKey = QStringLiteral("library/tileSize");
const QString sortKey = QStringLiteral("library/sort"), groupKey = QStringLiteral("library/grouping"),
              overlayKey = QStringLiteral("preview/overlay"), noiseKey = QStringLiteral("preview/noiseFilter"),
              chipsKey = QStringLiteral("library/filter"), favouritesKey = QStringLiteral("library/favourites");

LibraryController::ThumbnailFactory thumbnailFactory() {
  return [folder = thumbnailCacheFolder()](const QString& id, const TaskControl& control) {
    return materialThumbnail(id, folder, control);
  };
}

}  // namespace

EditorParts::EditorParts()
    : libraryStore(QFileInfo(settings.fileName()).absolutePath() + QStringLiteral("/library.sqlite")),
      recentFiles(settings),
      controller(document, tasks),
      exports(document, tasks),
      exporter(document, tasks),
      library(tasks, thumbnailFactory(), ownMaterialsFolder()),
      preview(*new widgets::PreviewWidget),
      environment(tasks, preview.content()),
      libraryView(*new widgets::LibraryView(&library.model())),
      inspector(*new Inspector(document, controller, tasks)),
      comparisonBar(*new widgets::ComparisonBar),
      comparison(document, tasks, preview, comparisonBar),
      comparisonPanel(*new ComparisonPanel(comparison, tasks)),
      match(*new MatchController(document, controller, tasks, comparison, preview)),
      referencePanel(*new ReferencePanel(match, document, preview)),
      plots(*new PlotsPanel(document, tasks)),
      factors(*new FactorCurvesPanel(document, tasks)),
      interpolation(*new InterpolationPanel(document, tasks)),
      study(*new StudyWindow(document, tasks)),
      scene(*new ScenePanel(preview, document, tasks)),
      viewStrip(*new ViewStrip(preview, scene, environment, tasks)),
      acquisition(*new AcquisitionPanel(document, tasks)),
      photographs(*new PhotographPanel(acquisition, tasks)) {
  new HighlightDrag(preview, document);
  connectStandIns();
  connectLibrary();
  connectPlots();
  connectFirstPicture();
}

EditorParts::~EditorParts() = default;

void EditorParts::connectStandIns() {
  QObject::connect(&interpolation, &InterpolationPanel::subjectChanged, &comparison, [this] {
    comparison.setStandIn(StandIn::blend, interpolation.subject(), interpolation.description());
  });
  QObject::connect(&study, &StudyWindow::subjectChanged, &comparison,
                   [this] { comparison.setStandIn(StandIn::representation, study.subject(), study.shownName()); });
  QObject::connect(&comparison, &ComparisonController::standInDismissed, &comparison, [this](StandIn kind) {
    if (kind == StandIn::match) return match.leave();
    if (kind == StandIn::representation) return study.show(-1);
    interpolation.setShownInPreview(false);
  });
  QObject::connect(&interpolation, &InterpolationPanel::materialMade, &controller, &DocumentController::openInMemory);
  QObject::connect(&acquisition, &AcquisitionPanel::materialMade, &controller, &DocumentController::openInMemory);
  QObject::connect(&study, &StudyWindow::useRequested, &controller,
                   [this](const gonio::study::Representation& representation) { use(representation); });
  const RepresentationPanel* representation = inspector.representation();
  QObject::connect(&study, &StudyWindow::compareRequested, &comparison,
                   [this](const std::array<widgets::PreviewSubject, 2>& subjects, const std::array<QString, 2>& names) {
                     comparison.setPair({{{subjects[0], names[0]}, {subjects[1], names[1]}}});
                   });
  QObject::connect(&study, &StudyWindow::saveRequested, &exports,
                   [this](const QString& path, const QImage& picture) { exports.writePng(path, picture); });
  QObject::connect(&study, &StudyWindow::writeRequested, &exports, &FileExports::save);
  QObject::connect(representation, &RepresentationPanel::shownChanged, &comparison,
                   [this, representation] { comparison.setCode(representation->shown()); });
  QObject::connect(&comparison, &ComparisonController::codeDismissed, representation,
                   [representation] { representation->showEncoded().setChecked(false); });
  const WavelengthPanel* wavelength = inspector.wavelength();
  QObject::connect(wavelength, &WavelengthPanel::subjectsChanged, &comparison,
                   [this, wavelength] { comparison.setWavelength(wavelength->subjects()); });
}

void EditorParts::use(const gonio::study::Representation& representation) {
  // What has a place of its own goes there; the rest stays in the preview.
  if (representation.kind->use == gonio::study::RepresentationUse::editModel) {
    study.show(-1);
    controller.chooseModel(*representation.kind->model);
  } else if (representation.kind->use == gonio::study::RepresentationUse::showCode) {
    study.show(-1);
    inspector.unfoldRepresentation();
    inspector.representation()->setCoefficients(std::size_t(representation.budget));
    inspector.representation()->showEncoded().setChecked(true);
  }
}

void EditorParts::connectLibrary() {
  QObject::connect(&library, &LibraryController::titleChanged, &libraryView, &widgets::LibraryView::setTitle);
  QObject::connect(&library, &LibraryController::added, &libraryView.selection(), &widgets::LibrarySelection::select);
  QObject::connect(&libraryView, &widgets::LibraryView::visibleIdsChanged, &library, &LibraryController::setVisible);
  QObject::connect(&library.model(), &widgets::LibraryModel::notesChanged, &libraryView,
                   [this](const widgets::LibraryNotes& notes) { libraryStore.write(notes); });
  QObject::connect(&libraryView.selection(), &widgets::LibrarySelection::referenceRequested, &comparison,
                   &ComparisonController::openReference);
  QObject::connect(&controller, &DocumentController::opened, &libraryView, [this] {
    const QString source = QString::fromStdString(document.material()->material.source.path.string());
    const QString id = document.path().isEmpty() ? source : document.path();
    libraryView.selection().select(id);
    library.setReference(id);
    widgets::LibraryNote note = library.model().note(id);
    note.opened = QDateTime::currentDateTime();
    library.model().setNote(id, note);
  });
  QObject::connect(&libraryView.selection(), &widgets::LibrarySelection::largePictureRequested, &library,
                   [this](const QString& id) {
                     library.makeLargePicture(id, int(widgets::QuickLook::side * libraryView.devicePixelRatioF()));
                   });
  QObject::connect(&library, &LibraryController::largePictureMade, &libraryView.selection().quickLook(),
                   &widgets::QuickLook::setPicture);
  acquisition.controls().training().setShownIds([this] {
    const QAbstractItemModel& shown = *libraryView.list()->model();
    QStringList ids;
    for (int row = 0; row < shown.rowCount(); ++row)
      if (const QModelIndex index = shown.index(row, 0); index.flags() & Qt::ItemIsEnabled)
        if (const QString id = index.data(widgets::LibraryModel::IdRole).toString(); !isDocument(id)) ids << id;
    return ids;
  });
}

void EditorParts::connectPlots() {
  QObject::connect(&study.model(), &StudyModel::plottedChanged, &plots, [this] {
    std::vector<PlottedFit> fits;
    for (const fitting::FitResult* fit : study.model().plotted()) fits.push_back({fit->model, fit->parameters});
    plots.setOtherFits(fits);
  });
  QObject::connect(&plots, &PlotsPanel::pickingToggled, &preview.input(), &widgets::PreviewInput::setPicking);
  QObject::connect(&preview.input(), &widgets::PreviewInput::polarAnglePicked, &plots, &PlotsPanel::setThetaI);
  QObject::connect(inspector.plausibility(), &widgets::PlausibilityBadges::showRequested, &plots,
                   [this](const QString& check, double theta) {
                     plots.showAt(check == "energy" ? PlotKind::albedo : PlotKind::cartesian, theta);
                   });
}

void EditorParts::connectFirstPicture() {
  constexpr int maxMilliseconds = 2000;
  QObject::connect(&controller, &DocumentController::installing, &preview, [this] {
    if (!preview.isVisible()) return;
    m_requestsBefore = preview.lastRequest();
    m_awaitsPicture = true;
    tasks.hold(maxMilliseconds);
  });
  QObject::connect(&preview.content(), &widgets::PreviewContent::sceneChanged, &preview,
                   [this, last = preview.content().scene().name](const rendering::Scene& changed) mutable {
                     if (std::exchange(last, changed.name) == changed.name) return;
                     if (!preview.isVisible() || !preview.content().hasMaterial()) return;
                     m_requestsBefore = preview.lastRequest() - 1;  // the last one is of the new scene
                     m_awaitsPicture = true;
                     preview.setLoading(sceneTitle(changed.name));
                   });
  QObject::connect(&preview, &widgets::PreviewWidget::frameRendered, &controller, [this] {
    if (preview.shownRequest() <= m_requestsBefore) return;
    m_awaitsPicture = false;
    showLoading();
    tasks.release();
  });
  QObject::connect(&preview, &widgets::PreviewWidget::failed, &controller, [this] {
    m_awaitsPicture = false;
    showLoading();
  });
  QObject::connect(&tasks, &BackgroundTasks::changed, &preview, [this] { showLoading(); });
}

/// Until the first picture of a material or a scene, the picture of the one before is dimmed; a material of the library
/// shows its thumbnail at once.
void EditorParts::showLoading() {
  const QString opening = controller.opening();
  if (opening.isEmpty() && m_awaitsPicture) return;
  const widgets::LibraryThumbnail* known = library.model().thumbnail(opening);
  preview.setLoading(opening.section('/', -1), known ? known->image : QImage());
}

bool EditorParts::isSettled() const {
  const auto task = tasks.topmost();
  return (!task || task->quiet) && inspector.isSettled() && comparisonPanel.isSettled() && plots.isSettled() &&
         factors.isSettled() && !match.isMatching() && interpolation.isSettled() && acquisition.isSettled() &&
         photographs.isSettled() && library.isVisibleComplete() &&
         (!preview.content().hasMaterial() || preview.converged());
}

FigureDialog::Parts EditorParts::figureParts() {
  return {document, exports, tasks, settings, library.model(), [this] { return libraryView.selection().ids(); }};
}

void EditorParts::restoreSettings() {
  inspector.restoreState(settings);
  plots.restoreState(settings);
  study.restoreState(settings);
  libraryView.setTileSize(settings.value(tileKey, libraryView.tileSize()).toInt());
  libraryView.setSortMode(settings.value(sortKey, 0).toInt());
  libraryView.setGrouping(settings.value(groupKey, int(widgets::LibraryGrouping::source)).toInt());
  libraryView.setChipsShown(settings.value(chipsKey, false).toBool());
  library.model().setNotes(libraryStore.read());
  takeOldFavourites();
  preview.overlay()->setStatusWanted(settings.value(overlayKey, false).toBool());
  preview.setNoiseFiltered(settings.value(noiseKey, true).toBool());
  const QString folder = settings.value(libraryKey).toString();
  if (folder.isEmpty() || !QFileInfo::exists(folder))
    library.showBundled();
  else
    library.showFolder(folder);
}

/// The favourites that stood in the settings before there was the store.
void EditorParts::takeOldFavourites() {
  for (const QString& id : settings.value(favouritesKey).toStringList()) {
    widgets::LibraryNote note = library.model().note(id);
    note.favourite = true;
    library.model().setNote(id, note);
  }
  if (libraryStore.failure().isEmpty()) settings.remove(favouritesKey);
}

void EditorParts::saveSettings() {
  inspector.saveState(settings);
  plots.saveState(settings);
  study.saveState(settings);
  settings.setValue(tileKey, libraryView.tileSize());
  settings.setValue(sortKey, libraryView.sortMode());
  settings.setValue(groupKey, libraryView.grouping());
  settings.setValue(chipsKey, libraryView.chipsShown());
  settings.setValue(overlayKey, preview.overlay()->statusWanted());
  settings.setValue(noiseKey, preview.isNoiseFiltered());
  settings.setValue(libraryKey, library.folder());
}

}  // namespace gonio::app
