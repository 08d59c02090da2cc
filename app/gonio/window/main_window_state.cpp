// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors

#include <QDockWidget>
#include <QFileDialog>
#include <QMessageBox>

#include "app/gonio/document/material_files.h"
#include "app/gonio/window/main_window.h"
#include "app/gonio/window/view_state.h"
#include "widgets/library/library_view.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {
const QString geometryKey = QStringLiteral("window/geometry"), layoutKey = QStringLiteral("window/layout");
const QString libraryKey = QStringLiteral("library/folder"), tileKey = QStringLiteral("library/tileSize");
const QString sortKey = QStringLiteral("library/sort"), overlayKey = QStringLiteral("preview/overlay");
}  // namespace

void MainWindow::restoreSettings() {
  restoreGeometry(m_settings.value(geometryKey).toByteArray());
  restoreState(m_settings.value(layoutKey).toByteArray(), layoutVersion);
  m_inspector->restoreState(m_settings);
  m_plots->restoreState(m_settings);
  m_libraryView->setTileSize(m_settings.value(tileKey, m_libraryView->tileSize()).toInt());
  m_libraryView->setSortMode(m_settings.value(sortKey, 0).toInt());
  m_preview->setOverlayVisible(m_settings.value(overlayKey, true).toBool());
  const QString folder = m_settings.value(libraryKey).toString();
  if (folder.isEmpty() || !QFileInfo::exists(folder))
    m_libraryController.showBundled();
  else
    m_libraryController.showFolder(folder);
}

void MainWindow::saveSettings() {
  m_settings.setValue(geometryKey, saveGeometry());
  m_settings.setValue(layoutKey, saveState(layoutVersion));
  m_inspector->saveState(m_settings);
  m_plots->saveState(m_settings);
  m_settings.setValue(tileKey, m_libraryView->tileSize());
  m_settings.setValue(sortKey, m_libraryView->sortMode());
  m_settings.setValue(overlayKey, m_preview->overlayVisible());
  m_settings.setValue(libraryKey, m_libraryController.folder());
}

void MainWindow::resetLayout() {
  for (QDockWidget* dock : m_docks) dock->setFloating(false);
  restoreState(m_defaultLayout, layoutVersion);
}

bool MainWindow::save() {
  if (m_document.path().isEmpty()) return saveAs();
  return m_controller.save(m_document.path(), viewToJson(*m_preview));
}

bool MainWindow::saveAs() {
  if (!m_document.material()) return false;
  const QString suggested = m_document.path().isEmpty() ? m_document.name() + documentSuffix() : m_document.path();
  QString path =
      QFileDialog::getSaveFileName(this, tr("Save"), suggested, tr("Gonio document (*%1)").arg(documentSuffix()));
  if (path.isEmpty()) return false;
  if (!isDocument(path)) path += documentSuffix();
  return m_controller.save(path, viewToJson(*m_preview));
}

void MainWindow::offerRecovery() {
  const QString folder = Autosave::defaultDataFolder();
  for (const RecoverableWork& work : Autosave::recoverable(folder)) {
    const QString what = work.originalPath.isEmpty() ? tr("a document that was never saved") : work.originalPath;
    const auto answer =
        QMessageBox::question(this, tr("Recover unsaved work"),
                              tr("Gonio did not end well last time. Recover the unsaved changes of %1?").arg(what),
                              QMessageBox::Yes | QMessageBox::Discard | QMessageBox::Cancel);
    if (answer == QMessageBox::Discard) Autosave::forget(folder, work.autosavePath);
    if (answer != QMessageBox::Yes) continue;
    return m_controller.openRecovered(work.autosavePath, work.originalPath);
  }
}

}  // namespace gonio::app
