// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/library_store.h"

#include <QDir>
#include <QFileInfo>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QUuid>
#include <QVariant>
#include <algorithm>

namespace gonio::app {

namespace {
constexpr QChar betweenTags('\n');
}  // namespace

LibraryStore::LibraryStore(const QString& path) : m_connection(QUuid::createUuid().toString()) {
  QDir().mkpath(QFileInfo(path).absolutePath());
  QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), m_connection);
  database.setDatabaseName(path);
  if (!database.open()) {
    m_failure = database.lastError().text();
    return;
  }
  // A note is safe when the program ends, and does not wait for the disk.
  run(QStringLiteral("PRAGMA journal_mode = WAL"));
  run(QStringLiteral("PRAGMA synchronous = NORMAL"));
  run(
      QStringLiteral("CREATE TABLE IF NOT EXISTS notes (material TEXT PRIMARY KEY, favourite INTEGER NOT NULL, "
                     "rating INTEGER NOT NULL, tags TEXT NOT NULL, opened INTEGER)"));
}

LibraryStore::~LibraryStore() { QSqlDatabase::removeDatabase(m_connection); }

bool LibraryStore::run(const QString& statement, const QVariantList& values) {
  QSqlQuery query(QSqlDatabase::database(m_connection));
  const bool prepared = query.prepare(statement);
  for (const QVariant& value : values) query.addBindValue(value);
  const bool done = prepared && query.exec();
  m_failure = done ? QString() : query.lastError().text();
  return done;
}

widgets::LibraryNotes LibraryStore::read() const {
  widgets::LibraryNotes notes;
  QSqlQuery query(QSqlDatabase::database(m_connection));
  query.exec(QStringLiteral("SELECT material, favourite, rating, tags, opened FROM notes"));
  while (query.next()) {
    widgets::LibraryNote& note = notes[query.value(0).toString()];
    note.favourite = query.value(1).toBool();
    note.rating = std::clamp(query.value(2).toInt(), 0, widgets::LibraryNote::maxRating);
    note.tags = query.value(3).toString().split(betweenTags, Qt::SkipEmptyParts);
    if (!query.value(4).isNull()) note.opened = QDateTime::fromMSecsSinceEpoch(query.value(4).toLongLong());
  }
  return notes;
}

bool LibraryStore::write(const widgets::LibraryNotes& notes) {
  if (!run(QStringLiteral("BEGIN IMMEDIATE"))) return false;
  for (auto note = notes.begin(); note != notes.end(); ++note)
    if (!writeOne(note.key(), note.value())) {
      const QString failure = m_failure;
      run(QStringLiteral("ROLLBACK"));
      m_failure = failure;
      return false;
    }
  return run(QStringLiteral("COMMIT"));
}

bool LibraryStore::writeOne(const QString& id, const widgets::LibraryNote& note) {
  if (note.isEmpty()) return run(QStringLiteral("DELETE FROM notes WHERE material = ?"), {id});
  return run(
      QStringLiteral("INSERT OR REPLACE INTO notes VALUES (?, ?, ?, ?, ?)"),
      {id, note.favourite, note.rating, QString("").append(note.tags.join(betweenTags)),  // null would be no text
       note.opened.isNull() ? QVariant() : QVariant(note.opened.toMSecsSinceEpoch())});
}

}  // namespace gonio::app
