// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library_controller.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "app/gonio/material_files.h"
#include "core/io/material.h"

namespace gonio::app {

namespace {
const QString thumbnailKey = QStringLiteral("thumbnail");
}

LibraryController::LibraryController(BackgroundTasks& tasks, LookMaker makeLook, QObject* parent)
    : QObject(parent), m_tasks(tasks), m_makeLook(std::move(makeLook)) {}

void LibraryController::showBundled() {
  std::vector<widgets::LibraryItem> items;
  for (const io::LibraryEntry& entry : io::bundledLibrary())
    items.push_back({QString::fromStdString("library:" + entry.id), QString::fromStdString(entry.name),
                     QString::fromStdString(entry.description)});
  show(std::move(items), tr("Bundled library"), {});
}

void LibraryController::showFolder(const QString& folder) {
  std::vector<widgets::LibraryItem> items;
  const QDir dir(folder);
  for (const QFileInfo& file : dir.entryInfoList(materialFilePatterns(), QDir::Files | QDir::Readable, QDir::Name)) {
    const QString kind = file.suffix() == "bsdf"   ? tr("RGL file")
                         : file.suffix() == "pdv"  ? tr("PDV factors")
                         : file.suffix() == "code" ? tr("sparse code")
                                                   : tr("MERL file");
    items.push_back({file.absoluteFilePath(), file.completeBaseName(), tr("%1, %2").arg(kind, file.fileName())});
  }
  show(std::move(items), dir.dirName(), folder);
}

void LibraryController::show(std::vector<widgets::LibraryItem> items, const QString& title, const QString& folder) {
  m_tasks.drop(thumbnailKey);
  m_title = title;
  m_folder = folder;
  m_visible.clear();
  m_model.setItems(std::move(items));
  Q_EMIT titleChanged(m_title);
  makeNext();
}

void LibraryController::setVisible(const QStringList& ids) { m_visible = ids; }

bool LibraryController::isVisibleComplete() const {
  const QStringList pending = m_model.pending();
  return std::none_of(m_visible.begin(), m_visible.end(), [&](const QString& id) { return pending.contains(id); });
}

void LibraryController::makeNext() {
  const QStringList pending = m_model.pending();
  if (pending.isEmpty()) return;
  QString id = pending.first();
  for (const QString& visible : m_visible)
    if (pending.contains(visible)) {
      id = visible;
      break;
    }
  const double done = 1 - double(pending.size()) / m_model.rowCount();
  const QString title = tr("Pictures of the library: %n left", nullptr, int(pending.size()));
  m_tasks.run<widgets::LibraryLook>(
      {title, thumbnailKey, true},
      [make = m_makeLook, id, done](const TaskControl& control) {
        control.report(done);
        return make(id, {control.stop, {}});
      },
      [this, id](const widgets::LibraryLook& look) {
        m_model.setLook(id, look);
        makeNext();
      },
      [this, id](const QString& reason) {
        m_model.setFailure(id, reason);
        makeNext();
      });
}

}  // namespace gonio::app

#include "moc_library_controller.cpp"
