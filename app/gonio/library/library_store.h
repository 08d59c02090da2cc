// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <QVariant>

#include "widgets/library/library_note.h"

namespace gonio::app {

/// The user's notes on materials, in an SQLite file. Where it cannot be opened, notes last as long as the program.
class LibraryStore {
 public:
  /// @param path of the file, which is made where there is none, with its folder.
  explicit LibraryStore(const QString& path);
  ~LibraryStore();
  LibraryStore(const LibraryStore&) = delete;
  LibraryStore& operator=(const LibraryStore&) = delete;

  widgets::LibraryNotes read() const;
  /// In the file at once, all or none. An empty note leaves it. @returns whether they could be written.
  bool write(const widgets::LibraryNotes& notes);
  /// Why the last note was not kept, or why the file cannot be opened; empty: all is well.
  const QString& failure() const { return m_failure; }

 private:
  bool run(const QString& statement, const QVariantList& values = {});
  bool writeOne(const QString& id, const widgets::LibraryNote& note);

  QString m_connection, m_failure;
};

}  // namespace gonio::app
