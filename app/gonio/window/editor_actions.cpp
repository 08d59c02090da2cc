// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/editor_actions.h"

#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QFileDialog>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <algorithm>
#include <memory>
#include <optional>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/acquisition/photograph_panel.h"
#include "app/gonio/comparison/comparison_controller.h"
#include "app/gonio/document/document_controller.h"
#include "app/gonio/document/edit_steps.h"
#include "app/gonio/document/material_files.h"
#include "app/gonio/export/export_controller.h"
#include "app/gonio/inspector/inspector.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "app/gonio/library/library_controller.h"
#include "app/gonio/matching/match_controller.h"
#include "app/gonio/scene/environment_controller.h"
#include "app/gonio/study/study_window.h"
#include "app/gonio/window/document_files.h"
#include "app/gonio/window/help.h"
#include "app/gonio/window/preferences.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/parameters/control_panel.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/preview/preview_overlay.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

using widgets::CompareMode;
using Workspace = DockLayout::Workspace;

namespace {

constexpr double exposureStep = 0.5, darkest = -10, brightest = 10;

/// A line between two groups of actions.
Action line() { return {}; }

/// One of several modes, e.g. of the tone maps.
template <class Get, class Set, class Value>
Action modeAction(const QString& text, Value value, const Get& get, const Set& set) {
  return {.text = text,
          .run = [set, value] { set(value); },
          .checked = [get, value] { return get() == value; },
          .isChoice = true};
}

/// The parameter or control under the pointer or with the focus.
void resetCurrent(Document& document, const Inspector& inspector) {
  if (const auto control = inspector.controls()->currentControl()) return resetControl(document, *control);
  if (const auto diffuse = inspector.controls()->currentDiffuseParameter()) return resetParameter(document, *diffuse);
  const int parameter = inspector.parameters()->currentParameter();
  if (parameter >= 0) resetParameter(document, parameter);
}

/// At most one figure dialog.
void showFigure(const FigureDialog::Parts& parts, QWidget* window) {
  auto* dialog = window->findChild<FigureDialog*>();
  if (!dialog) {
    dialog = new FigureDialog(parts, window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
  }
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

}  // namespace

Action EditorActions::file(DocumentFiles& files, ExportController& exporter, LibraryController& library,
                           DockLayout& docks, const std::function<void()>& openWindow,
                           const std::function<void()>& quit, QWidget* window) {
  const auto hasMaterial = [&files] { return files.document().material() != nullptr; };
  const auto openFolder = [&library, &docks, window] {
    const QString folder = QFileDialog::getExistingDirectory(window, tr("Open Library Folder"), library.folder());
    if (folder.isEmpty()) return;
    library.showFolder(folder);
    docks.show(QStringLiteral("library"));
  };
  return {
      .text = tr("&File"),
      .rows = {{.text = tr("&New Window"), .keys = {QKeySequence::New}, .run = openWindow},
               {.text = tr("&Open..."),
                .icon = QStringLiteral("open"),
                .keys = {QKeySequence::Open},
                .run = [&files] { files.askAndOpen(); }},
               {.text = tr("Open &Recent"), .rows = {{.currentRows = [&files] { return recentFiles(files); }}}},
               line(),
               {.text = tr("Open &Library Folder..."),
                .icon = QStringLiteral("library"),
                .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_O},
                .run = openFolder},
               {.text = tr("&Bundled Library"), .run = [&library] { library.showBundled(); }},
               line(),
               {.text = tr("&Save"),
                .icon = QStringLiteral("save"),
                .keys = {QKeySequence::Save},
                .run = [&files] { files.save(); },
                .enabled = hasMaterial},
               {.text = tr("Save &As..."),
                .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_S},
                .run = [&files] { files.saveAs(); },
                .enabled = hasMaterial},
               {.text = tr("Save in Librar&y..."), .run = [&files] { files.saveInLibrary(); }, .enabled = hasMaterial},
               line(),
               {.text = tr("&Export BRDF..."),
                .keys = {Qt::CTRL | Qt::Key_E},
                .run = [&files] { files.exportBrdf(); },
                .enabled = hasMaterial},
               {.text = tr("Export for &Renderer..."),
                .icon = QStringLiteral("export"),
                .keys = {Qt::CTRL | Qt::Key_R},
                .run = [&files] { files.exportForRenderer(); },
                .enabled = hasMaterial},
               {.text = tr("Export A&gain"),
                .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_R},
                .run = [&exporter] { exporter.repeat(); },
                .enabled = [&exporter] { return exporter.canRepeat(); }},
               {.text = tr("&Keep Export Up to Date"),
                .help = tr("Repeats the last export whenever the edits have rested for a second"),
                .run = [&exporter] { exporter.setKeptUpToDate(!exporter.isKeptUpToDate()); },
                .enabled = [&exporter] { return exporter.canRepeat(); },
                .checked = [&exporter] { return exporter.isKeptUpToDate(); }},
               {.text = tr("Export &Image..."),
                .icon = QStringLiteral("image"),
                .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_E},
                .run = [&files] { files.exportImage(); },
                .enabled = hasMaterial},
               {.text = tr("Export Blender A&dd-on..."),
                .help = tr("Saves the add-on that opens documents and exports in Blender and reloads them when they "
                           "change; install it there in Edit > Preferences > Add-ons"),
                .run = [&files] { files.exportBlenderAddon(); }},
               line(),
               {.text = tr("&Close Window"), .keys = {QKeySequence::Close}, .run = [window] { window->close(); }},
               {.text = tr("&Quit"), .keys = {Qt::CTRL | Qt::Key_Q}, .run = quit}}};
}

std::vector<Action> EditorActions::recentFiles(DocumentFiles& files) {
  std::vector<Action> rows;
  for (const QString& path : files.recent().paths())
    rows.push_back({.text = widgets::menuText(path.section('/', -1)),
                    .help = path,
                    .run = [&files, path] { files.open(path); },
                    .enabled = [path] { return RecentFiles::exists(path); }});
  if (rows.empty()) return {{.text = tr("Nothing opened yet"), .enabled = [] { return false; }}};
  rows.push_back(line());
  rows.push_back({.text = tr("&Clear"), .run = [&files] { files.recent().clear(); }});
  return rows;
}

Action EditorActions::edit(Document& document, DocumentController& controller, const Inspector& inspector,
                           const widgets::PreviewWidget& preview, QSettings& settings, QAction* showHistory,
                           const std::function<void(const QString&)>& notify, QWidget* window) {
  History& history = document.history();
  const auto modelEdit = [&document] { return document.active<editing::DifferentialEdit>(); };
  // Looked up once per change: the clipboard may belong to another program.
  const auto pasteable = std::make_shared<bool>();
  const auto look = [pasteable] { *pasteable = !editsFromClipboard(QApplication::clipboard()->mimeData()).empty(); };
  QObject::connect(QApplication::clipboard(), &QClipboard::dataChanged, window, look);
  look();
  return {
      .text = tr("&Edit"),
      .rows = {
          // Qt's own actions take '&' in the name of an edit for the mark of a key.
          {.icon = QStringLiteral("undo"),
           .keys = {QKeySequence::Undo},
           .run = [&history] { history.undo(); },
           .enabled = [&history] { return history.canUndo(); },
           .currentText = [&history] { return tr("&Undo %1").arg(widgets::menuText(history.undoText())).trimmed(); }},
          {.icon = QStringLiteral("redo"),
           .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y},
           .run = [&history] { history.redo(); },
           .enabled = [&history] { return history.canRedo(); },
           .currentText = [&history] { return tr("&Redo %1").arg(widgets::menuText(history.redoText())).trimmed(); }},
          {.existing = showHistory},
          line(),
          {.text = tr("&Copy Edits"),
           .keys = {QKeySequence::Copy},
           .run =
               [&document, notify] {
                 QApplication::clipboard()->setMimeData(toClipboard(document.toEditDocument()));
                 QStringList names;
                 for (int i = 0; i < int(document.edits().size()); ++i) names << editName(document.edits(), i);
                 notify(tr("Copied the edits of %1: %2")
                            .arg(widgets::spacedName(document.name()), names.join(QStringLiteral(", "))));
               },
           .enabled = [&document] { return !document.edits().empty(); }},
          {.text = tr("&Paste Edits"),
           .keys = {QKeySequence::Paste},
           .run = [&controller] { controller.paste(editsFromClipboard(QApplication::clipboard()->mimeData())); },
           .enabled = [&document, pasteable] { return document.material() && *pasteable; }},
          line(),
          {.text = tr("Reset Pa&rameter"),
           .keys = {Qt::Key_Backspace},
           .help = tr("Resets the parameter under the pointer or with the focus"),
           .run = [&document, &inspector] { resetCurrent(document, inspector); },
           .enabled = [modelEdit] { return modelEdit() != nullptr; }},
          {.text = tr("Reset &All"),
           .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_Backspace},
           .run = [&document] { resetParameters(document); },
           .enabled = [modelEdit] { return modelEdit() && !modelEdit()->isIdentity(); }},
          line(),
          {.text = tr("&Preferences..."),
           .icon = QStringLiteral("settings"),
           .keys = {Qt::CTRL | Qt::Key_Comma},
           .run = [&settings, &history, &preview, window] {
             showPreferences(settings, history, preview.graphics(), window);
           }}}};
}

Action EditorActions::view(DockLayout& docks, ComparisonController& comparison, widgets::PreviewWidget& preview,
                           EnvironmentController& environment, MatchController& match, QSettings& settings,
                           QWidget* window) {
  std::vector<Action> rows{{.text = tr("La&youts"), .rows = layouts(docks, comparison)}};
  int number = 1;
  for (const QDockWidget* dock : docks.docks()) {
    rows.push_back({.existing = dock->toggleViewAction()});
    // Alt+1 to Alt+9, then Alt+0; there are no more digits.
    if (number <= 10) rows.back().keys = {Qt::ALT | Qt::Key(Qt::Key_0 + number++ % 10)};
  }
  rows.push_back(line());
  for (const Action& row : picture(preview)) rows.push_back(row);
  rows.push_back(toneMap(preview));
  rows.push_back(light(environment, preview.content(), window));
  rows.push_back(line());
  for (const Action& row : referenceImage(match, window)) rows.push_back(row);
  rows.push_back(line());
  rows.push_back(theme(settings));
  rows.push_back({.text = tr("F&ull Screen"),
                  .keys = {Qt::Key_F11},
                  .run = [window] { window->setWindowState(window->windowState() ^ Qt::WindowFullScreen); },
                  .checked = [window] { return window->isFullScreen(); }});
  rows.push_back({.text = tr("Reset Layou&t"), .run = [&docks] { docks.reset(); }});
  return {.text = tr("&View"), .rows = rows};
}

QStringList EditorActions::workspaceNames() { return {tr("&Edit"), tr("&Compare"), tr("&Analyse"), tr("&Measure")}; }

void EditorActions::showWorkspace(DockLayout& docks, ComparisonController& comparison, Workspace workspace) {
  docks.showWorkspace(workspace);
  if (workspace == Workspace::compare && comparison.comparison().mode == CompareMode::off) comparison.toggle();
}

std::vector<Action> EditorActions::layouts(DockLayout& docks, ComparisonController& comparison) {
  std::vector<Action> rows;
  for (const QString& name : workspaceNames()) {
    const auto number = int(rows.size());
    rows.push_back({.text = name,
                    .keys = {Qt::CTRL | Qt::Key(Qt::Key_1 + number)},
                    .run = [&docks, &comparison, number] { showWorkspace(docks, comparison, Workspace(number)); }});
  }
  return rows;
}

std::vector<Action> EditorActions::picture(widgets::PreviewWidget& preview) {
  const auto expose = [&preview](double stops) { preview.setExposure(std::clamp(stops, darkest, brightest)); };
  const auto exposure = [&preview] { return preview.display().exposure; };
  return {{.id = "overlay",
           .text = tr("Preview &Overlay"),
           .keys = {Qt::CTRL | Qt::Key_B},
           .help = tr("Shows scene, exposure, time, samples and effects of the image over the preview"),
           .run = [shown = preview.overlay()] { shown->setStatusWanted(!shown->statusWanted()); },
           .checked = [shown = preview.overlay()] { return shown->statusWanted(); }},
          {.id = "noise",
           .text = tr("Filter &Noise"),
           .help = tr("Smooths the image while it has few samples. Measurements, rendered images and difference images "
                      "are never filtered; Copy Image and the export of the preview as shown contain what the preview "
                      "shows."),
           .run = [&preview] { preview.setNoiseFiltered(!preview.isNoiseFiltered()); },
           .checked = [&preview] { return preview.isNoiseFiltered(); }},
          {.id = "frame", .text = tr("&Frame Object (F)"), .run = [&preview] { preview.input().frameObject(); }},
          {.id = "reset-view", .text = tr("&Reset View (R)"), .run = [&preview] { preview.input().resetView(); }},
          line(),
          {.text = tr("&Brighter"),
           .keys = {Qt::CTRL | Qt::Key_BracketRight},
           .run = [expose, exposure] { expose(exposure() + exposureStep); }},
          {.text = tr("&Darker"),
           .keys = {Qt::CTRL | Qt::Key_BracketLeft},
           .run = [expose, exposure] { expose(exposure() - exposureStep); }},
          {.text = tr("Reset &Exposure"), .keys = {Qt::CTRL | Qt::Key_Backslash}, .run = [expose] { expose(0); }}};
}

Action EditorActions::toneMap(widgets::PreviewWidget& preview) {
  const auto get = [&preview] { return preview.display().toneMap; };
  const auto set = [&preview](rendering::ToneMap toneMap) {
    widgets::DisplaySettings display = preview.display();
    display.toneMap = toneMap;
    preview.setDisplay(display);
  };
  return {.text = tr("&Tone Map"),
          .rows = {modeAction(tr("&Clamp"), rendering::ToneMap::clamp, get, set),
                   modeAction(tr("&Filmic"), rendering::ToneMap::filmic, get, set)}};
}

Action EditorActions::light(EnvironmentController& environment, widgets::PreviewContent& preview, QWidget* window) {
  const auto choice = [&environment](const QString& text, const QString& name) {
    const auto current = [&environment] {
      return environment.isFromScene() ? std::optional<QString>() : environment.name();
    };
    return modeAction(text, name, current, [&environment](const QString& chosen) { environment.open(chosen); });
  };
  const auto recent = [&environment, choice] {
    std::vector<Action> rows;
    for (const QString& path : environment.recent()) {
      rows.push_back(choice(widgets::menuText(path.section('/', -1)), path));
      rows.back().help = path;
    }
    return rows;
  };
  const auto open = [&environment, window] {
    const QString purpose = QStringLiteral("environment");
    const QString path = QFileDialog::getOpenFileName(window, tr("Open Environment"), widgets::dialogFolder(purpose),
                                                      tr("Environments (*.hdr *.exr);;All files (*)"));
    widgets::rememberDialogFolder(purpose, path);
    if (!path.isEmpty()) environment.open(path);
  };
  const auto isBlurred = [&preview] { return preview.scene().showEnvironment && preview.scene().blurBackground; };
  const auto hasEnvironment = [&preview] { return preview.scene().environment != nullptr; };
  Action distant = choice(tr("&Distant Light"), {});
  distant.keys = {Qt::CTRL | Qt::Key_L};
  return {.id = "light",
          .text = tr("&Light"),
          .rows = {{.text = tr("From S&cene"),
                    .help = tr("Uses the light of the scene; a light chosen below stays when the scene changes"),
                    .run = [&environment] { environment.useSceneEnvironment(); },
                    .checked = [&environment] { return environment.isFromScene(); },
                    .isChoice = true},
                   choice(tr("&Studio"), QStringLiteral("studio")),
                   choice(tr("&Rim Lights"), QStringLiteral("rim-lights")),
                   choice(tr("S&ky"), QStringLiteral("sky")),
                   choice(tr("&Furnace"), QStringLiteral("furnace")),
                   distant,
                   line(),
                   {.currentRows = recent},
                   {.id = "open-environment", .text = tr("&Open Environment..."), .run = open},
                   line(),
                   {.text = tr("Show En&vironment"),
                    .run =
                        [&preview] {
                          preview.setBackground(!preview.scene().showEnvironment, preview.scene().blurBackground);
                        },
                    .enabled = hasEnvironment,
                    .checked = [&preview] { return preview.scene().showEnvironment; }},
                   {.text = tr("Bl&ur Environment"),
                    .run =
                        [&preview, isBlurred] {
                          const bool blurs = !isBlurred();
                          preview.setBackground(blurs || preview.scene().showEnvironment, blurs);
                        },
                    .enabled = hasEnvironment,
                    .checked = isBlurred}}};
}

std::vector<Action> EditorActions::referenceImage(MatchController& match, QWidget* window) {
  const auto open = [&match, window] {
    const QString purpose = QStringLiteral("reference-image");
    const QString path =
        QFileDialog::getOpenFileName(window, tr("Open Reference Image"), widgets::dialogFolder(purpose),
                                     tr("Images (%1);;All files (*)").arg(referenceImagePatterns()));
    widgets::rememberDialogFolder(purpose, path);
    if (!path.isEmpty()) match.open(path);
  };
  return {{.id = "open-reference-image",
           .text = tr("Open Refere&nce Image..."),
           .help = tr("Shows a photograph or a render of a sphere beside the preview, to match the material with it"),
           .run = open},
          {.text = tr("&Match Reference Image"),
           .help = tr("Fits the controls of the selected edit so that the material looks like the reference image"),
           .run = [&match] { match.match(); },
           .enabled = [&match] { return match.canMatch(); }},
          {.text = tr("Remo&ve Reference Image"),
           .run = [&match] { match.remove(); },
           .enabled = [&match] { return match.image().has_value(); }}};
}

Action EditorActions::theme(QSettings& settings) {
  const auto get = [&settings] { return themeByName(settings.value("theme").toString()); };
  const auto set = [&settings](Theme theme) {
    settings.setValue("theme", themeName(theme));
    applyTheme(*qApp, theme);
  };
  return {.text = tr("T&heme"),
          .rows = {modeAction(tr("Follow &System"), Theme::system, get, set),
                   modeAction(tr("&Light"), Theme::light, get, set), modeAction(tr("&Dark"), Theme::dark, get, set)}};
}

Action EditorActions::material(DocumentFiles& files, DocumentController& controller, BackgroundTasks& tasks,
                               ComparisonController& comparison, DockLayout& docks, StudyWindow& study,
                               InterpolationPanel& interpolation, AcquisitionPanel& acquisition,
                               PhotographPanel& photographs) {
  const Document& document = files.document();
  const auto hasMaterial = [&document] { return document.material() != nullptr; };
  const auto isWorking = [&tasks] {
    const auto task = tasks.topmost();
    return task && !task->quiet;
  };
  return {
      .text = tr("&Material"),
      .rows = {
          {.text = tr("&Fit"),
           .keys = {Qt::CTRL | Qt::Key_F5},
           .help = tr("Fits the model in use to the measurement"),
           .run = [&controller] { controller.fit(); },
           .enabled = hasMaterial},
          {.text = tr("Fit &All"),
           .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_F5},
           .help = tr("Fits every model and ranks them"),
           .run =
               [&study] {
                 study.present(StudyWindow::ResultsPage);
                 study.fitAll();
               },
           .enabled = hasMaterial},
          {.text = tr("&Save Fit..."),
           .help = tr("Saves the fitted model, without the measurement, as a table"),
           .run = [&files] { files.saveFit(); },
           .enabled = [&document] { return document.active<editing::DifferentialEdit>() != nullptr; }},
          {.text = tr("&Blend..."),
           .keys = {Qt::CTRL | Qt::Key_I},
           .help = tr("Blends the open material with others; the open material is put in slot A if this slot is empty"),
           .run =
               [&docks, &interpolation] {
                 docks.show(QStringLiteral("interpolation"));
                 interpolation.begin();
               }},
          {.text = tr("&Open Blend as Material"),
           .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_K},
           .help = tr("Opens the blend of the Blend panel as a material; Undo restores the previous material"),
           .run = [&interpolation] { interpolation.openAsMaterial(); }},
          {.text = tr("Ac&quire..."),
           .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_A},
           .help = tr("Chooses directions to measure and reconstructs a material from a few measurements"),
           .run =
               [&docks, &acquisition] {
                 docks.show(QStringLiteral("acquisition"));
                 acquisition.startButton().setFocus();
               }},
          {.text = tr("From P&hotographs..."),
           .help = tr("Reconstructs a material from photographs of a sphere under known light (EXR or HDR images)"),
           .run =
               [&docks, &photographs] {
                 docks.show(QStringLiteral("photographs"));
                 photographs.present();
               }},
          // What is shown instead of the material goes first: that loses no work.
          {.text = tr("&Cancel"),
           .keys = {Qt::Key_Escape},
           .help = tr("Shows the open material if the preview shows something else; otherwise stops the most recent "
                      "task"),
           .run = [&tasks,
                   &comparison] { comparison.isReplaced() ? comparison.dismissStandIn() : tasks.cancelTopmost(); },
           .enabled = [isWorking, &comparison] { return comparison.isReplaced() || isWorking(); }}}};
}

Action EditorActions::analyse(const FigureDialog::Parts& figures, ComparisonController& comparison, StudyWindow& study,
                              QWidget* window) {
  const auto hasMaterial = [&document = figures.document] { return document.material() != nullptr; };
  const auto getMode = [&comparison] { return comparison.comparison().mode; };
  const auto setMode = [&comparison](CompareMode mode) {
    widgets::PreviewComparison changed = comparison.comparison();
    changed.mode = mode;
    comparison.setComparison(changed);
  };
  return {
      .text = tr("&Analyse"),
      .rows = {
          {.text = tr("&Compare"),
           .keys = {Qt::Key_C},
           .help = tr("Compares two materials or states, such as measured and edited, in the preview; hold \\ to see "
                      "only the second"),
           .run = [&comparison] { comparison.toggle(); },
           .checked = [getMode] { return getMode() != CompareMode::off; }},
          {.text = tr("Comparison M&ode"),
           .rows = {modeAction(tr("&Off"), CompareMode::off, getMode, setMode),
                    modeAction(tr("&Split"), CompareMode::split, getMode, setMode),
                    modeAction(tr("&Flicker"), CompareMode::flicker, getMode, setMode),
                    modeAction(tr("&Difference"), CompareMode::difference, getMode, setMode),
                    modeAction(tr("S&ide by Side"), CompareMode::twoUp, getMode, setMode)}},
          {.text = tr("Compare with &Another Material..."),
           .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_C},
           .run = [&comparison] { Q_EMIT comparison.referenceRequested(); }},
          {.text = tr("S&tudy..."),
           .help = tr("Compares the accuracy and the cost of representations: results, chart and contact sheet"),
           .run = [&study] { study.present(StudyWindow::ResultsPage); }},
          {.text = tr("&Measure Representations"),
           .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_M},
           .help = tr("The error and the cost of every representation of the material"),
           .run =
               [&study] {
                 study.present(StudyWindow::ResultsPage);
                 study.measureOpen();
               },
           .enabled = hasMaterial},
          {.text = tr("Contact S&heet..."),
           .help = tr("The measured representations as images side by side, with error maps"),
           .run = [&study] { study.present(StudyWindow::SheetPage); },
           .enabled = hasMaterial},
          {.text = tr("F&igure..."),
           .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_F},
           .help = tr("Makes a figure for a paper: a grid of materials and representations with error maps, insets and "
                      "numbers"),
           .run = [figures, window] { showFigure(figures, window); }}}};
}

Action EditorActions::help(const std::function<void()>& search, const std::function<QString()>& shortcuts,
                           QWidget* window) {
  return {
      .text = tr("&Help"),
      .rows = {{.text = tr("&Search..."), .keys = {Qt::CTRL | Qt::Key_K, Qt::CTRL | Qt::Key_F}, .run = search},
               {.text = tr("&Guide"), .run = [window] { openGuide(window, guidePages().front().file); }},
               {.text = tr("S&hortcuts"),
                .keys = {Qt::Key_F1, Qt::Key_Question},
                .run = [shortcuts, window] { showPage(tr("Shortcuts"), shortcuts(), window); }},
               {.text = tr("&Reproduce the Dissertation"),
                .help = tr("How goniotool makes the figures of Tongbuasirilai 2023 from your files, with a report"),
                .run = [window] { openGuide(window, QStringLiteral("reproduction.md")); }},
               {.text = tr("&Formulae"), .run = [window] { showPage(tr("Formulae"), formulaePage(), window); }},
               line(),
               {.text = tr("&About Gonio"), .run = [window] { showPage(tr("About Gonio"), aboutPage(), window); }}}};
}

}  // namespace gonio::app
