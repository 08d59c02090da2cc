// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/file_menu.h"

#include <QApplication>
#include <QFileDialog>

#include "app/gonio/document/document.h"
#include "app/gonio/document/material_files.h"
#include "app/gonio/export/export_dialog.h"
#include "app/gonio/library/library_controller.h"
#include "app/gonio/window/dock_layout.h"
#include "app/gonio/window/document_files.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/preview/preview_content.h"

namespace gonio::app {

FileMenu::FileMenu(DocumentFiles& files, ExportController& exporter, const widgets::PreviewContent& preview,
                   LibraryController& library, DockLayout& docks, QSettings& settings, const WindowActions& windows,
                   QWidget* window)
    : QMenu(tr("&File"), window),
      m_files(files),
      m_exporter(exporter),
      m_preview(preview),
      m_library(library),
      m_docks(docks),
      m_settings(settings) {
  addOpening(windows.openNew);
  addSeparator();
  addSaving();
  addSeparator();
  addAction(tr("&Close Window"), QKeySequence::Close, window, &QWidget::close);
  addAction(tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), qApp, windows.quit);
}

void FileMenu::addOpening(const std::function<void()>& newWindow) {
  addAction(tr("&New Window"), QKeySequence::New, this, newWindow);
  addAction(tr("&Open..."), QKeySequence::Open, &m_files, &DocumentFiles::askAndOpen);
  QMenu* recent = addMenu(tr("Open &Recent"));
  const auto refill = [this, recent] { fillRecent(recent); };
  connect(this, &QMenu::aboutToShow, this, refill);
  connect(&m_files.document(), &Document::materialChanged, this, refill);
  fillRecent(recent);
  addSeparator();
  addAction(tr("Open &Library Folder..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O), this, &FileMenu::openFolder);
  addAction(tr("&Bundled Library"), &m_library, &LibraryController::showBundled);
}

void FileMenu::addSaving() {
  QList<QAction*> needMaterial;
  needMaterial << addAction(tr("&Save"), QKeySequence::Save, &m_files, &DocumentFiles::save);
  needMaterial << addAction(tr("Save &As..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), &m_files,
                            &DocumentFiles::saveAs);
  needMaterial << addAction(tr("Save in Librar&y..."), &m_files, &DocumentFiles::saveInLibrary);
  addSeparator();
  needMaterial << addAction(tr("&Export BRDF..."), QKeySequence(Qt::CTRL | Qt::Key_E), &m_files,
                            &DocumentFiles::exportBrdf);
  needMaterial << addAction(tr("Export for &Renderer..."), QKeySequence(Qt::CTRL | Qt::Key_R), this,
                            &FileMenu::exportForRenderer);
  QAction* again = addAction(tr("Export A&gain"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R), &m_exporter,
                             &ExportController::repeat);
  const auto showAgain = [this, again] { again->setEnabled(m_exporter.canRepeat()); };
  connect(&m_exporter, &ExportController::lastChanged, again, showAgain);
  showAgain();
  needMaterial << addAction(tr("Export &Image..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E), &m_files,
                            &DocumentFiles::exportImage);
  const auto update = [this, needMaterial] {
    for (QAction* action : needMaterial) action->setEnabled(m_files.document().material() != nullptr);
  };
  connect(&m_files.document(), &Document::materialChanged, this, update);
  update();
}

void FileMenu::fillRecent(QMenu* menu) {
  menu->clear();
  for (const QString& path : m_files.recent().paths()) {
    QAction* action =
        menu->addAction(widgets::menuText(path.section('/', -1)), this, [this, path] { m_files.open(path); });
    action->setToolTip(path);
    action->setEnabled(RecentFiles::exists(path));
  }
  if (menu->isEmpty()) {
    menu->addAction(tr("Nothing opened yet"))->setEnabled(false);
    return;
  }
  menu->setToolTipsVisible(true);
  menu->addSeparator();
  menu->addAction(tr("&Clear"), this, [this] { m_files.recent().clear(); });
}

void FileMenu::exportForRenderer() {
  auto* dialog = new ExportDialog(m_exporter, m_settings, m_preview.scene(), parentWidget());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void FileMenu::openFolder() {
  const QString folder =
      QFileDialog::getExistingDirectory(parentWidget(), tr("Open Library Folder"), m_library.folder());
  if (folder.isEmpty()) return;
  m_library.showFolder(folder);
  m_docks.show(QStringLiteral("library"));
}

}  // namespace gonio::app

#include "moc_file_menu.cpp"
