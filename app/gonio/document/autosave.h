// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>

#include "core/documents/edit_document.h"

namespace gonio::app {

/// A copy of unsaved work left behind by a program that crashed or was killed.
struct RecoverableWork {
  QString autosavePath;
  QString originalPath;  ///< empty for a document that was never saved
};

/// Writes a copy of a modified document every minute, and removes it when the document is saved or closed normally.
/// A copy is stored beside its document, or in the user's data folder if the document has no file or its folder is not
/// writable. Each has a name of its own, so that several editors can edit one document. A lock file
/// distinguishes copies of running programs from abandoned ones.
class Autosave : public QObject {
  Q_OBJECT

 public:
  static constexpr int intervalSeconds = 60;

  /// `snapshot` returns the document to write, or nullopt if everything is saved.
  using Snapshot = std::function<std::optional<documents::EditDocument>()>;
  Autosave(QString dataFolder, Snapshot snapshot, QObject* parent = nullptr);
  ~Autosave() override;

  /// Sets the document's path; empty if it was never saved. Writes the copy of this document first, if it has unsaved
  /// changes, and then removes the previous one. @return as update().
  bool setDocumentPath(const QString& path);
  /// Writes the copy now, or removes it if everything is saved. @return false if there are unsaved changes and they
  /// could not be copied.
  bool update();
  void discard();

  /// The copies of programs that no longer run.
  static QList<RecoverableWork> recoverable(const QString& dataFolder);
  /// Removes a copy and its record. A path that is not the copy of a record in the folder is left alone.
  static void forget(const QString& dataFolder, const QString& autosavePath);
  static QString defaultDataFolder();

 private:
  struct Copy {
    QString path, record;
    std::unique_ptr<QLockFile> lock;  ///< null: there is no copy
  };
  enum class Place { besideDocument, dataFolder };
  Copy newCopy(Place place) const;
  /// Writes the document to the current copy. @return false if the file cannot be written.
  bool write(const documents::EditDocument& document) const;
  static void remove(Copy copy);

  QString m_dataFolder;
  Snapshot m_snapshot;
  QString m_documentPath;
  Copy m_current;
  QTimer m_timer;
};

}  // namespace gonio::app
