// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/autosave.h"

#include "app/gonio/document/material_files.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUuid>
#include <utility>

namespace gonio::app {

namespace {

// Each copy has a record in the data folder: a text file with the copy's path and the document's path, and a lock.
const QString recordSuffix = QStringLiteral(".record");
constexpr qsizetype shortIdLength = 8;

QString readLine(QFile& file) { return QString::fromUtf8(file.readLine()).chopped(1); }

RecoverableWork readRecord(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  RecoverableWork work;
  work.autosavePath = readLine(file);
  work.originalPath = readLine(file);
  return work;
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

void Autosave::setDocumentPath(const QString& path) {
  Copy previous = std::exchange(m_current, {});
  m_documentPath = path;
  update();
  remove(std::move(previous));
}

Autosave::Copy Autosave::newCopy(Place place) const {
  const QString id = QUuid::createUuid().toString(QUuid::WithoutBraces);
  QDir().mkpath(m_dataFolder);
  Copy copy;
  copy.record = m_dataFolder + '/' + id + recordSuffix;
  copy.path = place == Place::dataFolder ? m_dataFolder + '/' + id + documentSuffix()
                                         : m_documentPath + '.' + id.left(shortIdLength) + ".autosave";
  copy.lock = std::make_unique<QLockFile>(copy.record + ".lock");
  copy.lock->setStaleLockTime(0);
  copy.lock->tryLock();
  QFile record(copy.record);
  if (record.open(QIODevice::WriteOnly)) record.write((copy.path + '\n' + m_documentPath + '\n').toUtf8());
  return copy;
}

void Autosave::remove(Copy copy) {
  if (!copy.lock) return;
  QFile::remove(copy.path);
  QFile::remove(copy.record);
}

void Autosave::update() {
  const auto document = m_snapshot();
  if (!document) return discard();
  if (!m_current.lock) m_current = newCopy(m_documentPath.isEmpty() ? Place::dataFolder : Place::besideDocument);
  if (write(*document)) return;
  // The document's folder may be read-only or gone; saving will say so when the user asks for it.
  Copy previous = std::exchange(m_current, newCopy(Place::dataFolder));
  // An older copy is better than none.
  if (!write(*document)) std::swap(previous, m_current);
  remove(std::move(previous));
}

bool Autosave::write(const editing::EditDocument& document) const {
  try {
    editing::writeDocument(document, m_current.path.toStdString());
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
    const RecoverableWork work = readRecord(record.absoluteFilePath());
    if (QFileInfo::exists(work.autosavePath))
      found.append(work);
    else
      QFile::remove(record.absoluteFilePath());
  }
  return found;
}

void Autosave::forget(const QString& dataFolder, const QString& autosavePath) {
  const QDir folder(dataFolder);
  for (const QFileInfo& record : folder.entryInfoList({"*" + recordSuffix}, QDir::Files))
    if (readRecord(record.absoluteFilePath()).autosavePath == autosavePath) QFile::remove(record.absoluteFilePath());
  QFile::remove(autosavePath);
}

}  // namespace gonio::app

#include "moc_autosave.cpp"
