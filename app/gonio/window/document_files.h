// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "app/gonio/document/autosave.h"

class QSettings;
class QWidget;

namespace gonio::widgets {
class PreviewWidget;
}

namespace gonio::app {

class Document;
class DocumentController;
class RecentFiles;

/// The files of a document as the user meets them: opening, saving and exporting with their questions, the recent
/// files, the copies of unsaved work.
class DocumentFiles : public QObject {
  Q_OBJECT

 public:
  /// @param window the parent of the dialogs. @param preview its view is saved.
  DocumentFiles(Document& document, DocumentController& controller, RecentFiles& recent, QSettings& settings,
                widgets::PreviewWidget& preview, QWidget* window);

  const Document& document() const { return m_document; }
  RecentFiles& recent() { return m_recent; }

  /// Opens a file after asking what to do with unsaved changes.
  void open(const QString& path);
  void askAndOpen();
  /// Saves under the known path, else asks for one. False when it was not saved.
  bool save();
  bool saveAs();
  void exportBrdf();
  void exportImage();
  /// Offers work that an earlier run left behind.
  void offerRecovery();
  /// Asks about unsaved changes and removes the copy of unsaved work. False when the document is to stay open.
  bool close();

 private:
  bool mayDiscard();
  void savePng(const QString& path);
  void updateAutosave();

  Document& m_document;
  DocumentController& m_controller;
  RecentFiles& m_recent;
  QSettings& m_settings;
  widgets::PreviewWidget& m_preview;
  QWidget* m_window;
  Autosave m_autosave;
};

}  // namespace gonio::app
