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

/// A copy of unsaved work that was left by a program that did not end well.
struct RecoverableWork {
  QString autosavePath;
  QString originalPath;  ///< empty for a document that was never saved
};

/// Writes a copy of a modified document every minute, and removes it when the document is saved or closed in order.
/// Copies lie beside their document, those of unsaved documents in the user's data folder. A lock distinguishes the
/// copies of running programs from those that were left behind.
class Autosave : public QObject {
  Q_OBJECT

 public:
  static constexpr int intervalSeconds = 60;

  /// `snapshot` gives the document to write, or nothing when there is nothing unsaved.
  using Snapshot = std::function<std::optional<editing::EditDocument>()>;
  Autosave(QString dataFolder, Snapshot snapshot, QObject* parent = nullptr);
  ~Autosave() override;

  /// Where the document lives; empty while it was never saved. Forgets the copy made so far.
  void setDocumentPath(const QString& path);
  /// Writes now if there is something to write, else removes the copy.
  void update();
  void discard();
  QString currentCopy() const { return m_copy; }

  /// Copies of programs that no longer run.
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
