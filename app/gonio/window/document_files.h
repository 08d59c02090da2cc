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
class BackgroundTasks;
class DocumentController;
class ComparisonController;
struct FileSave;
class FileExports;
class LibraryController;
class RecentFiles;

/// The files of a document as the user meets them: opening, saving and exporting with their questions, the recent
/// files, the copies of unsaved work.
class DocumentFiles : public QObject {
  Q_OBJECT

 public:
  /// What it works with; all of it outlives this object.
  struct Parts {
    Document& document;
    DocumentController& controller;
    FileExports& exports;
    BackgroundTasks& tasks;
    RecentFiles& recent;
    widgets::PreviewWidget& preview;  ///< its view is saved
    const ComparisonController& comparison;
    LibraryController& library;
    QSettings& settings;
  };

  /// @param window the parent of the dialogs.
  DocumentFiles(const Parts& parts, QWidget* window);

  const Document& document() const { return m_parts.document; }
  RecentFiles& recent() { return m_parts.recent; }

  /// Opens a file after asking what to do with unsaved changes.
  void open(const QString& path);
  void askAndOpen();
  /// Saves under the known path, else asks for one. False when it was not saved.
  bool save();
  bool saveAs();
  /// Asks for a name and saves the document among the user's own materials.
  void saveInLibrary();
  void exportBrdf();
  void exportImage();
  /// Asks for a name and writes it in the background.
  void saveBeside(const FileSave& save);
  /// Offers work that an earlier run left behind.
  void offerRecovery();
  /// Asks about unsaved changes and exports under way, and removes the copy of unsaved work. False when the document is
  /// to stay open.
  bool close();

 private:
  bool saveTo(const QString& path);
  bool mayDiscard();
  bool mayStopExports();
  void askAboutChangedSource(const QString& text);
  void updateAutosave();

  Parts m_parts;
  QWidget* m_window;
  Autosave m_autosave;
};

}  // namespace gonio::app
