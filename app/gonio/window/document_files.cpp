// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/document_files.h"

#include <QFileDialog>
#include <QMessageBox>
#include <QSettings>

#include "app/gonio/document/document_controller.h"
#include "app/gonio/document/material_files.h"
#include "app/gonio/document/recent_files.h"
#include "app/gonio/window/view_state.h"
#include "core/io/image_io.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {

const QString openFolderKey = QStringLiteral("folders/open");

/// With the suffix when the user left it out.
QString withSuffix(const QString& path, const QString& suffix) {
  return path.isEmpty() || path.endsWith(suffix, Qt::CaseInsensitive) ? path : path + suffix;
}

}  // namespace

DocumentFiles::DocumentFiles(Document& document, DocumentController& controller, RecentFiles& recent,
                             QSettings& settings, widgets::PreviewWidget& preview, QWidget* window)
    : m_document(document),
      m_controller(controller),
      m_recent(recent),
      m_settings(settings),
      m_preview(preview),
      m_window(window),
      m_autosave(Autosave::defaultDataFolder(), [this]() -> std::optional<editing::EditDocument> {
        if (!m_document.isModified()) return std::nullopt;
        editing::EditDocument stored = m_document.toEditDocument();
        stored.view = viewToJson(m_preview);
        return stored;
      }) {
  connect(&m_document, &Document::materialReplaced, this, &DocumentFiles::updateAutosave);
  connect(&m_controller, &DocumentController::opened, this, [this](const QString& path) {
    updateAutosave();
    if (!path.isEmpty()) m_recent.add(path);
  });
  connect(&m_controller, &DocumentController::recovered, this,
          [](const QString& autosavePath) { Autosave::forget(Autosave::defaultDataFolder(), autosavePath); });
  connect(&m_controller, &DocumentController::saved, this, [this](const QString& path) {
    m_autosave.setDocumentPath(path);
    m_recent.add(path);
  });
}

void DocumentFiles::updateAutosave() {
  m_autosave.setDocumentPath(m_document.path());
  m_autosave.update();
}

void DocumentFiles::open(const QString& path) {
  if (mayDiscard()) m_controller.open(path);
}

void DocumentFiles::askAndOpen() {
  const QString path =
      QFileDialog::getOpenFileName(m_window, tr("Open"), m_settings.value(openFolderKey).toString(), openFilter());
  if (path.isEmpty()) return;
  m_settings.setValue(openFolderKey, QFileInfo(path).absolutePath());
  open(path);
}

bool DocumentFiles::mayDiscard() {
  if (!m_document.isModified()) return true;
  const auto answer =
      QMessageBox::question(m_window, tr("Unsaved changes"), tr("Save changes to %1?").arg(m_document.name()),
                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

bool DocumentFiles::close() {
  if (!mayDiscard()) return false;
  m_autosave.discard();
  return true;
}

bool DocumentFiles::save() {
  if (m_document.path().isEmpty()) return saveAs();
  return m_controller.save(m_document.path(), viewToJson(m_preview));
}

bool DocumentFiles::saveAs() {
  if (!m_document.material()) return false;
  const QString suggested = m_document.path().isEmpty() ? m_document.name() + documentSuffix() : m_document.path();
  QString path =
      QFileDialog::getSaveFileName(m_window, tr("Save"), suggested, tr("Gonio document (*%1)").arg(documentSuffix()));
  if (path.isEmpty()) return false;
  if (!isDocument(path)) path += documentSuffix();
  return m_controller.save(path, viewToJson(m_preview));
}

void DocumentFiles::exportBrdf() {
  if (!m_document.material()) return;
  const std::vector<exports::MaterialForm> forms = exports::formsOf(*m_document.base());
  QStringList filters;
  for (const exports::MaterialForm form : forms) filters << formFilter(form);
  const auto suffixOf = [&](exports::MaterialForm form) { return formatSuffix(exports::formatOf(form)); };
  QString chosen = filters.front();
  QString path = QFileDialog::getSaveFileName(m_window, tr("Export BRDF"), m_document.name() + suffixOf(forms.front()),
                                              filters.join(QStringLiteral(";;")), &chosen);
  if (path.isEmpty()) return;
  exports::MaterialForm form = forms[std::size_t(std::max(qsizetype(0), filters.indexOf(chosen)))];
  // A typed suffix counts more than the list.
  for (const exports::MaterialForm other : forms)
    if (path.endsWith(suffixOf(other), Qt::CaseInsensitive) && suffixOf(other) != suffixOf(form)) {
      form = other;
      break;
    }
  m_controller.exportMaterial(withSuffix(path, suffixOf(form)), form);
}

void DocumentFiles::exportImage() {
  const QString path =
      QFileDialog::getSaveFileName(m_window, tr("Export Image"), m_document.name() + ".png",
                                   tr("PNG (current view) (*.png);;OpenEXR, rendered in linear light (*.exr)"));
  if (path.isEmpty()) return;
  if (path.endsWith(QStringLiteral(".exr"), Qt::CaseInsensitive))
    m_controller.exportExr(path, m_preview.scene(), m_preview.overrides(), m_preview.others());
  else
    savePng(withSuffix(path, QStringLiteral(".png")));
}

void DocumentFiles::savePng(const QString& path) {
  const QImage picture = m_preview.grabPicture().convertToFormat(QImage::Format_RGBA8888);
  std::vector<unsigned char> bytes;
  for (int y = 0; y < picture.height(); ++y)
    bytes.insert(bytes.end(), picture.constScanLine(y), picture.constScanLine(y) + 4 * picture.width());
  try {
    io::writePng(bytes, picture.width(), picture.height(), path.toStdString());
    Q_EMIT m_controller.exported(path);
  } catch (const Error& error) {
    Q_EMIT m_controller.failed(tr("Cannot export the picture"), QString::fromUtf8(error.what()));
  }
}

void DocumentFiles::offerRecovery() {
  const QString folder = Autosave::defaultDataFolder();
  for (const RecoverableWork& work : Autosave::recoverable(folder)) {
    const QString what = work.originalPath.isEmpty() ? tr("a document that was never saved") : work.originalPath;
    const auto answer =
        QMessageBox::question(m_window, tr("Recover unsaved work"),
                              tr("Gonio did not exit cleanly. Recover the unsaved changes to %1?").arg(what),
                              QMessageBox::Yes | QMessageBox::Discard | QMessageBox::Cancel);
    if (answer == QMessageBox::Discard) Autosave::forget(folder, work.autosavePath);
    if (answer != QMessageBox::Yes) continue;
    return m_controller.openRecovered(work.autosavePath, work.originalPath);
  }
}

}  // namespace gonio::app

#include "moc_document_files.cpp"
