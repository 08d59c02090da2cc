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
/// Copies are stored beside their document, those of documents without a file in the user's data folder. A lock file
/// distinguishes copies of running programs from abandoned ones.
class Autosave : public QObject {
  Q_OBJECT

 public:
  static constexpr int intervalSeconds = 60;

  /// `snapshot` returns the document to write, or nullopt if everything is saved.
  using Snapshot = std::function<std::optional<editing::EditDocument>()>;
  Autosave(QString dataFolder, Snapshot snapshot, QObject* parent = nullptr);
  ~Autosave() override;

  /// Sets the document's path; empty if it was never saved. Forgets the copy made so far.
  void setDocumentPath(const QString& path);
  /// Writes the copy now, or removes it if everything is saved.
  void update();
  void discard();
  QString currentCopy() const { return m_copy; }

  /// The copies of programs that no longer run.
  static QList<RecoverableWork> recoverable(const QString& dataFolder);
  static void forget(const QString& dataFolder, const QString& autosavePath);
  static QString defaultDataFolder();

 private:
  QString m_dataFolder;
  Snapshot m_snapshot;
  QString m_documentPath, m_copy, m_record;
  std::unique_ptr<QLockFile> m_lock;
  QTimer m_timer;
};

}  // namespace gonio::app
