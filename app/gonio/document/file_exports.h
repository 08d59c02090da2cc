// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "app/gonio/document/file_saves.h"
#include "app/gonio/document/picture_export.h"
#include "core/materials/material_formats.h"

namespace gonio::app {

/// Writes the document's material and pictures of it to files in the background, one after the other. Never replaces
/// the files that the document uses.
class FileExports : public QObject {
  Q_OBJECT

 public:
  FileExports(Document& document, BackgroundTasks& tasks, QObject* parent = nullptr);

  /// Whether a file is used by the document; if so, emits failed().
  bool refuses(const QString& path);
  /// Writes the edited material in a format. If content is lost, emits lossesFound() before anything is written.
  void writeMaterial(const QString& path, const materials::MaterialFormat& format);
  /// Renders the edited material on the CPU; the user can pause it.
  void renderPicture(const PictureExport& picture);
  /// Writes what another panel saves (factors, a code, a fit, a figure) with FileSave::write, in the background.
  void save(const QString& path, const FileSave& save);
  /// Called in the background.
  using Caption = std::function<QString(const TaskControl&)>;
  /// Writes a picture unchanged, with 8 bits per channel. @param caption text of a line below it.
  void writePng(const QString& path, const QImage& picture, const Caption& caption = {});

 Q_SIGNALS:
  void exported(const QString& path);
  void failed(const QString& title, const QString& text);
  /// What a file of the material would lose, with its measured error. Nothing is written unless `write` is called.
  void lossesFound(const QString& path, const QString& text, const std::function<void()>& write);
  /// The user cancelled; nothing was written.
  void cancelled(const QString& path);

 private:
  using FileBytes = std::shared_ptr<const std::vector<std::byte>>;
  void writeBytes(const QString& path, const FileBytes& bytes);
  template <class Result>
  void run(const QString& title, const QString& path, std::function<Result(const TaskControl&)> work,
           std::function<void(const Result&)> done, const std::shared_ptr<Pause>& pause = nullptr);

  Document& m_document;
  BackgroundTasks& m_tasks;
};

}  // namespace gonio::app
