// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/autosave.h"

#include "app/gonio/document/material_files.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QUuid>
#include <optional>
#include <utility>

namespace gonio::app {

namespace {

// Each copy has a record in the data folder, ID.record, with a lock: a JSON object with the path of its document. The
// path of the copy follows from both, so that no record, however damaged, names another file.
const QString recordSuffix = QStringLiteral(".record");
const QString documentKey = QStringLiteral("document");
constexpr qsizetype shortIdLength = 8;
constexpr qint64 maxRecordBytes = 1 << 16;

QString copyInFolder(const QString& dataFolder, const QString& id) { return dataFolder + '/' + id + documentSuffix(); }

QString copyBeside(const QString& documentPath, const QString& id) {
  return documentPath + '.' + id.left(shortIdLength) + QStringLiteral(".autosave");
}

QByteArray recordText(const QString& documentPath) {
  return QJsonDocument(QJsonObject{{documentKey, documentPath}}).toJson();
}

/// The path of the document, empty if it was never saved; nullopt if the record cannot be read.
std::optional<QString> recordedDocument(const QString& recordPath) {
  QFile file(recordPath);
  if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
  const QByteArray content = file.read(maxRecordBytes);
  if (const QJsonValue path = QJsonDocument::fromJson(content).object().value(documentKey); path.isString())
    return path.toString();
  // Until November 2026: two lines, the copy and its document.
  const QList<QByteArray> lines = content.split('\n');
  if (lines.size() != 3 || !lines[2].isEmpty()) return std::nullopt;
  return QString::fromUtf8(lines[1]);
}

/// The copy that belongs to a record. @return an empty path if the record cannot be read or the copy does not exist.
RecoverableWork workOf(const QFileInfo& record) {
  const std::optional<QString> document = recordedDocument(record.absoluteFilePath());
  if (!document) return {};
  const QString id = record.completeBaseName();
  QStringList places{copyInFolder(record.absolutePath(), id)};
  if (!document->isEmpty()) places << copyBeside(*document, id);
  for (const QString& copy : places)
    if (QFileInfo(copy).isFile()) return {copy, *document};
  return {{}, *document};
}

}  // namespace

Autosave::Autosave(QString dataFolder, Snapshot snapshot, QObject* parent)
    : QObject(parent), m_dataFolder(std::move(dataFolder)), m_snapshot(std::move(snapshot)) {
  m_timer.setInterval(intervalSeconds * 1000);
  connect(&m_timer, &QTimer::timeout, this, &Autosave::update);
  m_timer.start();
}

Autosave::~Autosave() = default;

QString Autosave::defaultDataFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/recovery");
}

bool Autosave::setDocumentPath(const QString& path) {
  Copy previous = std::exchange(m_current, {});
  m_documentPath = path;
  const bool written = update();
  remove(std::move(previous));
  return written;
}

Autosave::Copy Autosave::newCopy(Place place) const {
  const QString id = QUuid::createUuid().toString(QUuid::WithoutBraces);
  QDir().mkpath(m_dataFolder);
  Copy copy;
  copy.record = m_dataFolder + '/' + id + recordSuffix;
  copy.path = place == Place::dataFolder ? copyInFolder(m_dataFolder, id) : copyBeside(m_documentPath, id);
  copy.lock = std::make_unique<QLockFile>(copy.record + ".lock");
  copy.lock->setStaleLockTime(0);
  copy.lock->tryLock();
  QFile record(copy.record);
  if (record.open(QIODevice::WriteOnly)) record.write(recordText(m_documentPath));
  return copy;
}

void Autosave::remove(Copy copy) {
  if (!copy.lock) return;
  QFile::remove(copy.path);
  QFile::remove(copy.record);
}

bool Autosave::update() {
  const auto document = m_snapshot();
  if (!document) {
    discard();
    return true;
  }
  if (!m_current.lock) m_current = newCopy(m_documentPath.isEmpty() ? Place::dataFolder : Place::besideDocument);
  if (write(*document)) return true;
  // The document's folder may be read-only or gone; saving will say so when the user asks for it.
  Copy previous = std::exchange(m_current, newCopy(Place::dataFolder));
  const bool written = write(*document);
  // An older copy is better than none.
  if (!written) std::swap(previous, m_current);
  remove(std::move(previous));
  return written;
}

bool Autosave::write(const documents::EditDocument& document) const {
  try {
    documents::writeDocument(document, m_current.path.toStdString());
    return true;
  } catch (const Error&) {
    return false;
  }
}

void Autosave::discard() { remove(std::exchange(m_current, {})); }

QList<RecoverableWork> Autosave::recoverable(const QString& dataFolder) {
  QList<RecoverableWork> found;
  const QDir folder(dataFolder);
  for (const QFileInfo& record : folder.entryInfoList({"*" + recordSuffix}, QDir::Files, QDir::Time)) {
    QLockFile lock(record.absoluteFilePath() + ".lock");
    lock.setStaleLockTime(0);
    if (!lock.tryLock(0)) continue;  // its program still runs
    const RecoverableWork work = workOf(record);
    if (!work.autosavePath.isEmpty())
      found.append(work);
    else if (recordedDocument(record.absoluteFilePath()))
      QFile::remove(record.absoluteFilePath());
  }
  return found;
}

void Autosave::forget(const QString& dataFolder, const QString& autosavePath) {
  if (autosavePath.isEmpty()) return;
  const QDir folder(dataFolder);
  for (const QFileInfo& record : folder.entryInfoList({"*" + recordSuffix}, QDir::Files))
    if (workOf(record).autosavePath == autosavePath) {
      QFile::remove(autosavePath);
      QFile::remove(record.absoluteFilePath());
    }
}

}  // namespace gonio::app

#include "moc_autosave.cpp"
