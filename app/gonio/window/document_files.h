// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QString>
#include <nlohmann/json.hpp>

#include "app/gonio/document/autosave.h"
#include "core/rendering/scene.h"

class QSettings;
class QWidget;

namespace gonio::widgets {
class PreviewWidget;
}

namespace gonio::app {

class BackgroundTasks;
class ComparisonController;
class Document;
class DocumentController;
class EnvironmentController;
class ExportController;
class FileExports;
class LibraryController;
class RecentFiles;
class ScenePanel;
struct FileSave;

/// Scene, camera, light, exposure and tone map of a preview, in the format of .gonio files. Scene and environment are
/// stored by bundled name or file path.
nlohmann::json viewToJson(const widgets::PreviewWidget& preview);
/// The scene of a view; the single sphere if it does not name one.
QString sceneNameOf(const nlohmann::json& view);
/// How its mesh stands; y up and without turns if it is not stored.
rendering::MeshPose scenePoseOf(const nlohmann::json& view);

/// The user interface for files: opening, saving and exporting with their dialogs, recent files, and copies of unsaved
/// work.
class DocumentFiles : public QObject {
  Q_OBJECT

 public:
  /// The objects that are used; they must outlive this object.
  struct Parts {
    Document& document;
    DocumentController& controller;
    FileExports& exports;
    ExportController& exporter;
    BackgroundTasks& tasks;
    RecentFiles& recent;
    widgets::PreviewWidget& preview;  ///< its view is saved with the document, and restored
    ScenePanel& scene;
    EnvironmentController& environment;
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
  /// Saves to the document's path, or asks for one. @return false if it was not saved.
  bool save();
  bool saveAs();
  /// Asks for a name and saves the document among the user's own materials.
  void saveInLibrary();
  void exportBrdf();
  void exportForRenderer();
  void exportImage();
  /// Asks for a name and saves the add-on for Blender (resources/blender).
  void exportBlenderAddon();
  /// Asks for a name and saves the fitted model, without the measurement, as a table.
  void saveFit();
  /// Asks for the name of a file that a panel saves (factors, a code, a fit, a figure) and writes it in the background.
  void askAndSave(const FileSave& save);
  /// Asks which unsaved work of earlier runs is to be recovered. @return what the user wants back, newest first.
  QList<RecoverableWork> askForRecovery();
  /// Opens a copy of unsaved work, without asking about the open document.
  void recover(const RecoverableWork& work);
  /// Writes a copy of unsaved work now, which otherwise happens once a minute.
  void copyUnsavedWork() { m_autosave.update(); }
  /// Asks about unsaved changes and running exports, and removes the copy of unsaved work. @return false if the
  /// document should stay open.
  bool close();
  /// Whether close() discards unsaved changes without a question, because the user has answered it for all windows.
  void setDiscarding(bool discarding) { m_discarding = discarding; }

 private:
  void restoreView(const nlohmann::json& view);
  bool saveTo(const QString& path);
  /// Saves to the document's own path; asks first if another program has written to the file.
  bool saveAgain(const QString& path);
  bool mayDiscard();
  bool mayStopExports();
  void askAboutUnsavedChanges(const QString& replacement);
  void askAboutChangedSource(const QString& text);
  /// @return as Autosave::update().
  bool updateAutosave();

  Parts m_parts;
  QWidget* m_window;
  Autosave m_autosave;
  bool m_discarding = false;
};

}  // namespace gonio::app
