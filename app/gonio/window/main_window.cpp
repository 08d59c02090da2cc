// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/main_window.h"

#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QDialog>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QPointer>
#include <QScreen>
#include <QStatusBar>
#include <QStyle>
#include <QTimer>
#include <QUndoView>
#include <QVBoxLayout>
#include <utility>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/acquisition/photograph_panel.h"
#include "app/gonio/comparison/comparison_panel.h"
#include "app/gonio/comparison/reference_dialog.h"
#include "app/gonio/document/material_files.h"
#include "app/gonio/export/batch_dialog.h"
#include "app/gonio/factors/factor_curves_panel.h"
#include "app/gonio/inspector/inspector.h"
#include "app/gonio/inspector/representation_panel.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "app/gonio/matching/reference_panel.h"
#include "app/gonio/plots/plots_panel.h"
#include "app/gonio/scene/scene_panel.h"
#include "app/gonio/scene/view_strip.h"
#include "app/gonio/study/study_window.h"
#include "app/gonio/window/action_table.h"
#include "app/gonio/window/command_search.h"
#include "app/gonio/window/dock_layout.h"
#include "app/gonio/window/drop_target.h"
#include "app/gonio/window/editor_actions.h"
#include "app/gonio/window/help.h"
#include "app/gonio/window/preferences.h"
#include "app/gonio/window/start_page.h"
#include "app/gonio/window/status_line.h"
#include "app/gonio/window/window_keys.h"
#include "widgets/inputs/icons.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/library/library_selection.h"
#include "widgets/library/library_view.h"
#include "widgets/panels/message_bar.h"
#include "widgets/preview/comparison_bar.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {
constexpr QSize usualSize(1440, 900), minSize(960, 600);
/// Of the screen, where it is larger than the usual size: the rest shows that there are other windows.
constexpr double screenFraction = 0.9;
constexpr int libraryLines = 27, inspectorLines = 32;
}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      m_files(
          {m_parts.document, m_parts.controller, m_parts.exports, m_parts.exporter, m_parts.tasks, m_parts.recentFiles,
           m_parts.preview, m_parts.scene, m_parts.environment, m_parts.comparison, m_parts.library, m_parts.settings},
          this),
      m_docks(new DockLayout(*this)),
      m_messages(new widgets::MessageBar),
      m_start(new StartPage(m_parts.recentFiles, &m_parts.preview)) {
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumSize(minSize);
  // The title bar, which the window system adds, has to fit too.
  const QSize frame(0, style()->pixelMetric(QStyle::PM_TitleBarHeight));
  const QSize available = screen()->availableSize() - frame;
  resize((available * screenFraction).expandedTo(usualSize).boundedTo(available));
  addCentre();
  addDocks();
  m_status = new StatusLine(*statusBar(), m_parts.document, m_parts.tasks, m_parts.comparison, m_parts.preview);
  addMenus();
  connectDocument();
  connectMessages();
  connectRequests();
  connectStartPage();
  connectKinds();
  new WindowKeys(this, [this](bool held) { m_parts.preview.setFlickering(held); });
  const DropTarget::Actions drops{[this](const QString& path) { m_files.open(path); },
                                  [this](const QString& path) { m_parts.comparison.openReference(path); },
                                  [this](const QString& path) { m_parts.environment.open(path); },
                                  [this](const QString& path) { m_parts.scene.open(path); },
                                  [this](const QString& path) { m_parts.match.open(path); },
                                  [this](const QString& folder) { showFolder(folder); },
                                  [this](const QStringList& paths) {
                                    showFolder(QFileInfo(paths.front()).absolutePath());
                                    m_files.open(paths.front());
                                  }};
  new DropTarget(m_parts.preview, drops);
  new DropTarget(*this, drops, DropTarget::Sources::otherPrograms);
  m_docks->setDefault();
  m_docks->restore(m_parts.settings);
  applyPreferences(m_parts.settings, m_parts.document.history());
  m_parts.restoreSettings();
  connectNotes();
  showTitle();
  showGround();
  // Keys work at once, without a click first.
  m_start->openButton()->setFocus(Qt::OtherFocusReason);
}

MainWindow::~MainWindow() {
  // Widgets use the document, the controllers and the tasks until they are gone, so they go first.
  hide();
  delete m_actions;
  qDeleteAll(findChildren<QDialog*>(QString(), Qt::FindDirectChildrenOnly));
  m_parts.tasks.stopAll();
  qDeleteAll(findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly));
  delete takeCentralWidget();
}

void MainWindow::addCentre() {
  auto* centre = new QWidget;
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_messages);
  layout->addWidget(&m_parts.comparisonBar);
  auto* pictures = new QHBoxLayout;
  pictures->setSpacing(0);
  pictures->addWidget(&m_parts.preview, 1);
  pictures->addWidget(&m_parts.referencePanel, 1);
  layout->addLayout(pictures, 1);
  layout->addWidget(&m_parts.viewStrip);
  centre->setFocusProxy(&m_parts.preview);
  setCentralWidget(centre);
}

void MainWindow::addDocks() {
  m_parts.study.setParent(this, Qt::Window);
  m_docks->add(tr("Library"), "library", &m_parts.libraryView, Qt::LeftDockWidgetArea, libraryLines);
  m_docks->add(tr("Inspector"), "inspector", &m_parts.inspector, Qt::RightDockWidgetArea, inspectorLines);
  auto* history = new QUndoView(&m_parts.document.history());
  history->setEmptyLabel(tr("Opened"));
  history->setAccessibleName(tr("History"));
  m_docks->add(tr("History"), "history", history, Qt::RightDockWidgetArea)->hide();
  const std::tuple<QString, const char*, QWidget&> bottom[] = {
      {tr("Plots"), "plots", m_parts.plots},
      {tr("Comparison"), "comparison", m_parts.comparisonPanel},
      {tr("Factor curves"), "factors", m_parts.factors},
      {tr("Blend"), "interpolation", m_parts.interpolation},
      {tr("Scene"), "scene", m_parts.scene},
      {tr("Acquisition"), "acquisition", m_parts.acquisition},
      {tr("Photographs"), "photographs", m_parts.photographs}};
  for (const auto& [title, name, panel] : bottom) m_docks->add(title, name, &panel, Qt::BottomDockWidgetArea);
  const std::pair<const char*, const char*> icons[] = {
      {"library", "library"},         {"inspector", "sliders"}, {"history", "history"},     {"plots", "plots"},
      {"comparison", "comparison"},   {"factors", "curves"},    {"interpolation", "blend"}, {"scene", "scene"},
      {"acquisition", "acquisition"}, {"photographs", "image"}};
  for (const auto& [name, icon] : icons)
    m_docks->dock(name)->toggleViewAction()->setIcon(widgets::themedIcon(QString::fromLatin1(icon)));
  m_parts.libraryView.setEmptyText(tr("There are no materials in this folder (%1).\nFile > Bundled Library shows the "
                                      "materials that come with Gonio.")
                                       .arg(materialFilePatterns().join(' ')));
}

void MainWindow::addMenus() {
  EditorParts& p = m_parts;
  const auto search = [this] {
    auto* dialog = new CommandSearch({*m_actions, m_parts.document, m_parts.controller, m_files, m_parts.inspector,
                                      m_parts.scene, m_parts.environment, m_parts.library.model()},
                                     this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
  };
  m_actions = new ActionTable(
      *this,
      {EditorActions::file(
           m_files, p.exporter, p.library, *m_docks, [] { (new MainWindow)->show(); }, &MainWindow::quit, this),
       EditorActions::edit(
           p.document, p.controller, p.inspector, p.preview, p.settings, m_docks->dock("history")->toggleViewAction(),
           [this](const QString& notice) { m_status->showNotice(notice); }, this),
       EditorActions::view(*m_docks, p.comparison, p.preview, p.environment, p.match, p.settings, this),
       EditorActions::material(m_files, p.controller, p.tasks, p.comparison, *m_docks, p.study, p.interpolation,
                               p.acquisition, p.photographs),
       EditorActions::analyse(p.figureParts(), p.comparison, p.study, this),
       EditorActions::help(
           search, [this] { return shortcutsPage(m_actions->all()); }, this)});
  QStringList layouts;
  for (const QString& name : EditorActions::workspaceNames()) layouts << widgets::withoutKeyMarks(name);
  m_docks->addTabs(layouts, [this](DockLayout::Workspace workspace) {
    EditorActions::showWorkspace(*m_docks, m_parts.comparison, workspace);
  });
  for (int tab = 0; const char* icon : {"edit", "comparison", "plots", "acquisition"})
    m_docks->tabs()->setTabIcon(tab++, widgets::themedIcon(QString::fromLatin1(icon)));
  // What the states of the actions depend on.
  const auto follow = [this](auto* sender, auto... signal) {
    (connect(sender, signal, m_actions, &ActionTable::update), ...);
  };
  follow(&p.document, &Document::materialChanged, &Document::stateChanged, &Document::selectionChanged,
         &Document::editChanged);
  follow(&p.document.history(), &QUndoStack::canUndoChanged, &QUndoStack::canRedoChanged, &QUndoStack::undoTextChanged,
         &QUndoStack::redoTextChanged);
  follow(&p.exporter, &ExportController::lastChanged);
  follow(&p.tasks, &BackgroundTasks::changed);
  follow(&p.comparison, &ComparisonController::comparisonChanged, &ComparisonController::subjectsChanged);
  follow(&p.match, &MatchController::changed);
  follow(QApplication::clipboard(), &QClipboard::dataChanged);
}

void MainWindow::showPictureMenu(const QPoint& place) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  m_actions->update();
  for (const char* id : {"frame", "reset-view", "overlay", "noise", "light"}) menu->addAction(m_actions->action(id));
  if (m_parts.scene.showsMesh()) menu->addAction(tr("Turn Mesh"), &m_parts.scene, &ScenePanel::turnMesh);
  menu->addSeparator();
  menu->addAction(tr("Toggle Comparison"), &m_parts.comparison, &ComparisonController::toggle);
  menu->addAction(tr("Copy Image"), this, [this] {
    const QImage picture = m_parts.preview.grabPicture();
    QApplication::clipboard()->setImage(picture);
    m_status->showNotice(tr("Copied the image, %1 x %2 pixels").arg(picture.width()).arg(picture.height()));
  });
  menu->addAction(tr("Export Image..."), &m_files, &DocumentFiles::exportImage)
      ->setEnabled(m_parts.document.material() != nullptr);
  menu->popup(place);
}

void MainWindow::connectDocument() {
  connect(&m_parts.document, &Document::titleChanged, this, &MainWindow::showTitle);
  connect(&m_parts.document, &Document::materialChanged, m_messages, &QWidget::hide);
  connect(&m_parts.controller, &DocumentController::saved, this,
          [this](const QString& path) { m_status->showNotice(tr("Saved %1").arg(path)); });
  const auto written = [this](const QString& path) { m_status->showNotice(tr("Wrote %1").arg(path)); };
  const auto cancelled = [this](const QString& path) {
    m_status->showNotice(tr("Cancelled: %1 was not written").arg(path));
  };
  const auto follow = [this, written]<class... Part>(Part&... part) {
    (connect(&part, &Part::exported, this, written), ...);
  };
  follow(m_parts.exports, m_parts.exporter, m_parts.plots, m_parts.study, m_parts.acquisition, m_parts.photographs);
  connect(&m_parts.exports, &FileExports::cancelled, this, cancelled);
  connect(&m_parts.exporter, &ExportController::cancelled, this, cancelled);
}

/// Notes of the library that could not be read or saved are tried again, and the user is informed.
void MainWindow::connectNotes() {
  constexpr int retryMilliseconds = 5000;
  connect(&m_parts.library.model(), &widgets::LibraryModel::notesChanged, this, &MainWindow::showLostNotes);
  auto* retry = new QTimer(this);
  connect(retry, &QTimer::timeout, this, [this] {
    if (m_parts.libraryStore.retry()) m_parts.library.model().setNotes(m_parts.libraryStore.read());
    showLostNotes();
  });
  retry->start(retryMilliseconds);
  showLostNotes();
}

void MainWindow::showLostNotes() {
  const QString& failure = m_parts.libraryStore.failure();
  const QString text =
      failure.isEmpty() ? QString() : tr("Favourites, ratings and tags cannot be read or saved now: %1").arg(failure);
  const QString before = std::exchange(m_lostNotes, text);
  if (text == before) return;  // a dismissed message does not come back with each change of a note
  m_messages->withdraw(before);
  if (!text.isEmpty()) m_messages->showMessage(text);
}

void MainWindow::connectMessages() {
  const auto follow = [this]<class... Part>(Part&... part) {
    (connect(&part, &Part::failed, this, &MainWindow::showFailure), ...);
  };
  follow(m_parts.tasks, m_parts.controller, m_parts.exports, m_parts.exporter, m_parts.environment, m_parts.comparison,
         m_parts.match, m_parts.plots, m_parts.factors, m_parts.interpolation, m_parts.study, m_parts.scene,
         m_parts.acquisition, m_parts.photographs);
  connect(&m_parts.exporter, &ExportController::warned, m_messages, &widgets::MessageBar::showMessage);
  connect(&m_parts.scene, &ScenePanel::warned, m_messages, &widgets::MessageBar::showMessage);
  connect(&m_parts.environment, &EnvironmentController::warned, m_messages, &widgets::MessageBar::showMessage);
  connect(&m_parts.preview, &widgets::PreviewWidget::failed, m_messages, &widgets::MessageBar::showMessage);
  connect(&m_parts.document, &Document::refused, m_messages, &widgets::MessageBar::showMessage);
  connect(&m_parts.controller, &DocumentController::warned, m_messages, &widgets::MessageBar::showMessage);
  connect(&m_parts.controller, &DocumentController::proposalOffered, m_messages, &widgets::MessageBar::showProposal);
  connect(m_messages, &widgets::MessageBar::applied, &m_parts.controller, &DocumentController::applyProposal);
  connect(m_messages, &widgets::MessageBar::discarded, &m_parts.controller, &DocumentController::discardProposal);
}

/// Once the first is open; not where the user keeps the document that is.
void MainWindow::comparePair(const QString& first, const QString& second) {
  connect(
      &m_parts.controller, &DocumentController::opened, this,
      [this, first, second] {
        if (QString::fromStdString(m_parts.document.material()->material.source.path.string()) == first)
          m_parts.comparison.openReference(second);
      },
      Qt::SingleShotConnection);
  m_files.open(first);
}

void MainWindow::showFolder(const QString& folder) {
  m_parts.library.showFolder(folder);
  m_docks->show(QStringLiteral("library"));
}

/// What a part wants of the window: another file, a dock, a dialog.
void MainWindow::connectRequests() {
  connect(&m_parts.preview.input(), &widgets::PreviewInput::menuRequested, this, &MainWindow::showPictureMenu);
  connect(&m_parts.viewStrip, &ViewStrip::sceneFileRequested, &m_parts.scene, &ScenePanel::askForFile);
  connect(&m_parts.viewStrip, &ViewStrip::environmentFileRequested, m_actions->action("open-environment"),
          &QAction::trigger);
  connect(&m_parts.factors, &FactorCurvesPanel::saveRequested, &m_files, &DocumentFiles::askAndSave);
  connect(m_parts.inspector.representation(), &RepresentationPanel::saveRequested, &m_files,
          &DocumentFiles::askAndSave);
  connect(&m_parts.libraryView.selection(), &widgets::LibrarySelection::openRequested, &m_files, &DocumentFiles::open);
  connect(&m_parts.libraryView.selection(), &widgets::LibrarySelection::interpolationRequested, this,
          [this](const QStringList& ids) {
            m_docks->show(QStringLiteral("interpolation"));
            m_parts.interpolation.useMaterials(ids);
          });
  connect(&m_parts.libraryView.selection(), &widgets::LibrarySelection::pairRequested, this, &MainWindow::comparePair);
  connect(&m_parts.libraryView.selection(), &widgets::LibrarySelection::exportRequested, this,
          [this](const QStringList& ids) {
            auto* dialog = new BatchDialog(m_parts.exporter, m_parts.settings, ids, this);
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            dialog->open();
          });
  connect(&m_parts.libraryView.selection(), &widgets::LibrarySelection::studyRequested, this,
          [this](const QStringList& ids) {
            m_parts.study.setMaterials(ids);
            m_parts.study.present(StudyWindow::ResultsPage);
          });
  connect(&m_parts.inspector, &Inspector::factorEditRequested, this, [this] {
    m_docks->show(QStringLiteral("factors"));
    m_parts.factors.addEdit();
  });
  connect(&m_parts.comparison, &ComparisonController::referenceRequested, this,
          [this] { chooseMaterial({}, [this](const QString& path) { m_parts.comparison.openReference(path); }); });
  connect(&m_parts.acquisition, &AcquisitionPanel::measuredMaterialRequested, this, [this] {
    chooseMaterial(tr("Material to Measure"), [this](const QString& path) { m_parts.acquisition.measure(path); });
  });
}

/// The page shows while there is nothing else to show.
void MainWindow::connectStartPage() {
  const auto show = [this] {
    m_start->setWanted(!m_parts.document.material() && !m_parts.comparison.standIn());
    m_start->setOpening(m_parts.controller.opening().section('/', -1));
  };
  connect(&m_parts.document, &Document::materialChanged, m_start, show);
  connect(&m_parts.comparison, &ComparisonController::subjectsChanged, m_start, show);
  connect(&m_parts.tasks, &BackgroundTasks::changed, m_start, show);
  connect(m_start, &StartPage::openRequested, &m_files, &DocumentFiles::open);
  connect(m_start, &StartPage::fileRequested, &m_files, &DocumentFiles::askAndOpen);
  connect(m_start, &StartPage::kindRequested, this, [this](EditingKind kind) {
    const QStringList materials = StartPage::materials();
    if (kind == EditingKind::blend)
      m_parts.interpolation.useMaterials(materials.mid(0, 2));
    else
      m_files.open(materials.front());
    showKind(kind);
  });
  show();
}

/// The row of the inspector marks the kind of editing whose panel is in view.
void MainWindow::connectKinds() {
  const auto mark = [this] {
    const auto isInView = [this](const char* name) { return !m_docks->dock(name)->visibleRegion().isEmpty(); };
    m_parts.inspector.setKind(isInView("interpolation") ? EditingKind::blend
                              : isInView("factors")     ? EditingKind::curves
                                                        : EditingKind::sliders);
  };
  for (const char* name : {"interpolation", "factors"})
    connect(m_docks->dock(name), &QDockWidget::visibilityChanged, &m_parts.inspector, mark, Qt::QueuedConnection);
  connect(&m_parts.inspector, &Inspector::kindChosen, this, &MainWindow::showKind);
}

void MainWindow::showKind(EditingKind kind) {
  m_docks->show(QStringLiteral("inspector"));
  switch (kind) {
    case EditingKind::sliders:
      for (const auto& other : {QStringLiteral("interpolation"), QStringLiteral("factors")})
        m_docks->show(other, false);
      break;
    case EditingKind::curves:
      m_docks->show(QStringLiteral("factors"));
      break;
    case EditingKind::blend:
      m_docks->show(QStringLiteral("interpolation"));
      if (m_parts.document.material()) m_parts.interpolation.begin();
  }
}

void MainWindow::chooseMaterial(const QString& title, const std::function<void(const QString&)>& chosen) {
  auto* dialog = new ReferenceDialog(m_parts.library.model(), this);
  if (!title.isEmpty()) dialog->setPurpose(title, tr("&Choose"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ReferenceDialog::chosen, this, chosen);
  dialog->open();
}

void MainWindow::showFailure(const QString& title, const QString& text) {
  auto* box = new QMessageBox(QMessageBox::Warning, title, title, QMessageBox::Ok, this);
  // What is wrong first; what each reader found is folded away.
  box->setInformativeText(text.section('\n', 0, 0));
  if (text.contains('\n')) box->setDetailedText(text.section('\n', 1));
  box->setTextFormat(Qt::PlainText);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

/// The ground of the picture is darker than the window in the dark theme, and mid-grey in a light one.
void MainWindow::showGround() {
  constexpr int middle = 128;
  widgets::DisplaySettings display = m_parts.preview.display();
  const widgets::DisplaySettings dark;
  const bool isDark = palette().color(QPalette::Window).lightness() < middle;
  display.backgroundCentre = isDark ? dark.backgroundCentre : QColor(150, 150, 152);
  display.backgroundEdge = isDark ? dark.backgroundEdge : QColor(118, 118, 120);
  m_parts.preview.setDisplay(display);
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) showGround();
}

void MainWindow::showTitle() {
  const Document& document = m_parts.document;
  const QString name = document.path().isEmpty() ? widgets::spacedName(document.name()) : document.name();
  setWindowTitle(tr("%1[*] - Gonio").arg(widgets::titleText(name)));
  setWindowModified(m_parts.document.isModified());
}

void MainWindow::quit() {
  QList<QPointer<MainWindow>> unsaved;
  QStringList names;
  for (QWidget* widget : QApplication::topLevelWidgets())
    if (auto* window = qobject_cast<MainWindow*>(widget); window && window->m_parts.document.isModified()) {
      unsaved << window;
      const Document& document = window->m_parts.document;
      names << (document.path().isEmpty() ? document.name() : document.path());
    }
  bool discards = false;
  if (!unsaved.isEmpty()) {
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                    names.size() == 1 ? tr("Save changes to this document before quitting?")
                                      : tr("Save changes to these %1 documents before quitting?").arg(names.size()),
                    QMessageBox::SaveAll | QMessageBox::Discard | QMessageBox::Cancel, unsaved.first());
    box.setInformativeText(names.join('\n'));
    const int answer = box.exec();
    if (answer != QMessageBox::SaveAll && answer != QMessageBox::Discard) return;
    discards = answer == QMessageBox::Discard;
  }
  for (const QPointer<MainWindow>& window : unsaved) {
    if (!window) continue;
    if (!discards && !window->m_files.save()) return;
    window->m_files.setDiscarding(discards);
  }
  QApplication::closeAllWindows();
  // Where running exports keep a window open, its next closing asks again.
  for (const QPointer<MainWindow>& window : unsaved)
    if (window) window->m_files.setDiscarding(false);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!m_files.close()) return event->ignore();
  m_docks->save(m_parts.settings);
  m_parts.saveSettings();
  event->accept();
}

}  // namespace gonio::app

#include "moc_main_window.cpp"
