// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/library_store.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QUuid>
#include <algorithm>
#include <utility>

namespace gonio::app {

namespace {

constexpr QChar betweenTags('\n');

using widgets::LibraryNote;
using widgets::LibraryNotes;

/// Columns besides the material, and their types.
constexpr std::pair<const char*, const char*> noteColumns[] = {{"favourite", "INTEGER NOT NULL DEFAULT 0"},
                                                               {"rating", "INTEGER NOT NULL DEFAULT 0"},
                                                               {"tags", "TEXT NOT NULL DEFAULT ''"},
                                                               {"opened", "INTEGER"}};

/// What is written of a note that was made before the stored one could be read: it removes nothing.
LibraryNote merged(LibraryNote stored, const LibraryNote& made) {
  stored.favourite |= made.favourite;
  if (made.rating > 0) stored.rating = made.rating;
  stored.tags << made.tags;
  stored.tags.removeDuplicates();
  if (made.opened.isValid()) stored.opened = made.opened;
  return stored;
}

QString reasonOf(const QSqlError& error, const QString& path) {
  const QString code = error.nativeErrorCode();  // SQLITE_BUSY, SQLITE_LOCKED
  if (code != "5" && code != "6") return QStringLiteral("%1: %2").arg(path, error.databaseText());
  return QCoreApplication::translate("LibraryStore", "%1 is locked by another program; Gonio will try again").arg(path);
}

}  // namespace

LibraryStore::LibraryStore(const QString& path) : m_connection(QUuid::createUuid().toString()), m_path(path) {
  QDir().mkpath(QFileInfo(path).absolutePath());
  QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), m_connection);
  database.setDatabaseName(path);
  // Windows wait for each other's notes; the user must not wait for a program that locks the file for longer.
  database.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=100"));
}

LibraryStore::~LibraryStore() { QSqlDatabase::removeDatabase(m_connection); }

bool LibraryStore::prepare() {
  QSqlDatabase database = QSqlDatabase::database(m_connection, false);
  if (!database.isOpen() && !database.open()) {
    m_failure = reasonOf(database.lastError(), m_path);
    return false;
  }
  QString columns = QStringLiteral("material TEXT PRIMARY KEY");
  for (const auto& [name, type] : noteColumns) columns += QStringLiteral(", %1 %2").arg(name, type);
  if (!run(QStringLiteral("CREATE TABLE IF NOT EXISTS notes (%1)").arg(columns)) || !addMissingColumns()) return false;
  // A note is safe when the program ends, and does not wait for the disk. Notes can be read where this is not possible.
  for (const char* setting : {"PRAGMA journal_mode = WAL", "PRAGMA synchronous = NORMAL"})
    QSqlQuery(database).exec(QLatin1String(setting));
  return true;
}

/// The file may be of an older or newer version.
bool LibraryStore::addMissingColumns() {
  QSqlQuery query(QSqlDatabase::database(m_connection, false));
  if (!run(query, QStringLiteral("SELECT name FROM pragma_table_info('notes')"))) return false;
  QStringList present;
  while (query.next()) present << query.value(0).toString().toLower();
  query.finish();
  for (const auto& [name, type] : noteColumns)
    if (!present.contains(QLatin1String(name)) &&
        !run(QStringLiteral("ALTER TABLE notes ADD COLUMN %1 %2").arg(name, type)))
      return false;
  present.removeAll(QStringLiteral("material"));
  for (const auto& column : noteColumns) present.removeAll(QLatin1String(column.first));
  m_hasOtherColumns = !present.isEmpty();
  return true;
}

bool LibraryStore::run(QSqlQuery& query, const QString& statement, const QVariantList& values) {
  const bool prepared = query.prepare(statement);
  for (const QVariant& value : values) query.addBindValue(value);
  const bool done = prepared && query.exec();
  m_failure = done ? QString() : reasonOf(query.lastError(), m_path);
  return done;
}

bool LibraryStore::run(const QString& statement, const QVariantList& values) {
  QSqlQuery query(QSqlDatabase::database(m_connection, false));
  return run(query, statement, values);
}

LibraryNotes LibraryStore::read() {
  LibraryNotes notes = m_pending;
  if (!prepare()) return notes;
  QSqlQuery query(QSqlDatabase::database(m_connection, false));
  if (!run(query, QStringLiteral("SELECT material, favourite, rating, tags, opened FROM notes"))) return notes;
  while (query.next()) {
    LibraryNote note;
    note.favourite = query.value(1).toBool();
    note.rating = std::clamp(query.value(2).toInt(), 0, LibraryNote::maxRating);
    note.tags = query.value(3).toString().split(betweenTags, Qt::SkipEmptyParts);
    if (!query.value(4).isNull()) note.opened = QDateTime::fromMSecsSinceEpoch(query.value(4).toLongLong());
    const QString id = query.value(0).toString();
    if (const auto pending = m_pending.find(id); pending == m_pending.end())
      notes[id] = note;
    else if (!m_isRead)
      notes[id] = *pending = merged(note, *pending);
  }
  m_isRead = true;
  notes.removeIf([](const auto& note) { return note.value().isEmpty(); });
  return notes;
}

bool LibraryStore::write(const LibraryNotes& notes) {
  m_pending.insert(notes);
  return writePending();
}

bool LibraryStore::retry() {
  const bool wasRead = m_isRead;
  if (!wasRead) read();
  if (m_isRead && !m_pending.isEmpty()) writePending();
  return m_isRead && !wasRead;
}

bool LibraryStore::writePending() {
  // Notes that were never read would be replaced.
  if (!m_isRead) read();
  if (!m_isRead || !run(QStringLiteral("BEGIN IMMEDIATE"))) return false;
  LibraryNotes failed;
  QString failure;
  for (auto note = m_pending.begin(); note != m_pending.end(); ++note)
    if (!writeOne(note.key(), note.value())) {
      failed.insert(note.key(), note.value());
      failure = m_failure;
    }
  if (!run(QStringLiteral("COMMIT"))) {
    failure = m_failure;
    run(QStringLiteral("ROLLBACK"));
  } else {
    m_pending = failed;
  }
  m_failure = failure;
  return failure.isEmpty();
}

bool LibraryStore::writeOne(const QString& id, const LibraryNote& note) {
  if (note.isEmpty() && !m_hasOtherColumns) return run(QStringLiteral("DELETE FROM notes WHERE material = ?"), {id});
  // The columns of others keep their values.
  const QVariantList values{note.favourite, note.rating,
                            QString("").append(note.tags.join(betweenTags)),  // null would be no text
                            note.opened.isNull() ? QVariant() : QVariant(note.opened.toMSecsSinceEpoch()), id};
  QSqlQuery query(QSqlDatabase::database(m_connection, false));
  if (!run(query, QStringLiteral("UPDATE notes SET favourite = ?, rating = ?, tags = ?, opened = ? WHERE material = ?"),
           values))
    return false;
  return query.numRowsAffected() > 0 ||
         run(QStringLiteral("INSERT INTO notes (favourite, rating, tags, opened, material) VALUES (?, ?, ?, ?, ?)"),
             values);
}

}  // namespace gonio::app
