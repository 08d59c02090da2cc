// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <QVariant>

#include "widgets/library/library_note.h"

namespace gonio::app {

/// The user's notes on materials, in an SQLite file. If the file cannot be opened, notes are lost when the program
/// ends.
class LibraryStore {
 public:
  /// @param path path of the file, which is created together with its folder if it does not exist.
  explicit LibraryStore(const QString& path);
  ~LibraryStore();
  LibraryStore(const LibraryStore&) = delete;
  LibraryStore& operator=(const LibraryStore&) = delete;

  widgets::LibraryNotes read() const;
  /// Writes notes to the file immediately, in one transaction. Empty notes are removed from the file. @return whether
  /// writing succeeded.
  bool write(const widgets::LibraryNotes& notes);
  /// Why the last note was not written or the file cannot be opened; empty: no failure.
  const QString& failure() const { return m_failure; }

 private:
  bool run(const QString& statement, const QVariantList& values = {});
  bool writeOne(const QString& id, const widgets::LibraryNote& note);

  QString m_connection, m_failure;
};

}  // namespace gonio::app
