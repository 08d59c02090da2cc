// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <QVariant>

#include "widgets/library/library_model.h"

class QSqlQuery;

namespace gonio::app {

/// The user's notes on materials, in an SQLite file, which other programs may use too. What cannot be read or written
/// now, because the file is locked or damaged, is tried again by retry(); notes that were never written are lost when
/// the program ends.
class LibraryStore {
 public:
  /// @param path path of the file, which is created together with its folder if it does not exist.
  explicit LibraryStore(const QString& path);
  ~LibraryStore();
  LibraryStore(const LibraryStore&) = delete;
  LibraryStore& operator=(const LibraryStore&) = delete;

  /// The notes in the file, with those that are still to be written; only the latter if the file cannot be read.
  widgets::LibraryNotes read();
  /// Writes notes to the file immediately, in one transaction. Empty notes are removed from the file. @return whether
  /// all were written; the others are still to be written.
  bool write(const widgets::LibraryNotes& notes);
  /// Reads and writes again what failed. @return whether the notes were read now and could not be before.
  bool retry();
  /// Why notes cannot be read or written; empty: no failure.
  const QString& failure() const { return m_failure; }

 private:
  bool prepare();
  bool addMissingColumns();
  bool run(QSqlQuery& query, const QString& statement, const QVariantList& values = {});
  bool run(const QString& statement, const QVariantList& values = {});
  bool writePending();
  bool writeOne(const QString& id, const widgets::LibraryNote& note);

  const QString m_connection, m_path;
  QString m_failure;
  bool m_isRead = false;            ///< all notes have been read once
  bool m_hasOtherColumns = false;   ///< made by another version of Gonio, or by another program
  widgets::LibraryNotes m_pending;  ///< still to be written
};

}  // namespace gonio::app
