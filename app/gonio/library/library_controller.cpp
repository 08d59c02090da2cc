// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/library_controller.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <chrono>

#include "app/gonio/document/material_files.h"
#include "app/gonio/library/sphere_picture.h"
#include "core/materials/material_formats.h"

namespace gonio::app {

namespace {

const QString thumbnailKey = QStringLiteral("thumbnail"), likenessKey = QStringLiteral("library-likeness"),
              largePictureKey = QStringLiteral("library-large-picture");

/// A picture, or why there is none.
struct Made {
  QString id;
  widgets::LibraryLook look;
  QString failure;
};

/// The first of the pictures: as many as take a tenth of a second. One at a time would wait for a frame of the preview
/// each.
std::vector<Made> madeInABatch(const LibraryController::LookMaker& make, const QStringList& ids,
                               const TaskControl& control) {
  constexpr std::chrono::milliseconds batchTime(100);
  const auto start = std::chrono::steady_clock::now();
  std::vector<Made> batch;
  for (const QString& id : ids) {
    Made& made = batch.emplace_back(Made{id, {}, {}});
    try {
      made.look = make(id, control);
    } catch (const Cancelled&) {
      throw;
    } catch (const std::exception& error) {
      made.failure = QString::fromStdString(error.what());
    }
    if (std::chrono::steady_clock::now() - start > batchTime) break;
  }
  return batch;
}

QString badgeOf(materials::LibraryOrigin origin) {
  switch (origin) {
    case materials::LibraryOrigin::measured:
      return LibraryController::tr("measured");
    case materials::LibraryOrigin::nearMeasured:
      return LibraryController::tr("near-measured");
    default:
      return LibraryController::tr("published fit");
  }
}

QString sourceOf(const materials::LibraryEntry& entry) {
  const QString prefix = QString::fromStdString(entry.id.substr(0, entry.id.find('/')));
  switch (entry.origin) {
    case materials::LibraryOrigin::measured:
      return LibraryController::tr("Measured: RGL");
    case materials::LibraryOrigin::nearMeasured:
      return LibraryController::tr("Near-measured copies: %1").arg(prefix.section('-', 0, 0).toUpper());
    default:
      return LibraryController::tr("Published fits: SGD of MERL");
  }
}

QString titled(const std::string& kind) {
  QString title = QString::fromStdString(kind);
  if (!title.isEmpty()) title[0] = title[0].toUpper();
  return title;
}

}  // namespace

LibraryController::LibraryController(BackgroundTasks& tasks, LookMaker makeLook, QObject* parent)
    : QObject(parent), m_tasks(tasks), m_makeLook(std::move(makeLook)) {}

void LibraryController::showBundled() {
  std::vector<widgets::LibraryItem> items;
  for (const materials::LibraryEntry& entry : materials::bundledLibrary())
    items.push_back({QString::fromStdString("library:" + entry.id), QString::fromStdString(entry.name),
                     QString::fromStdString(entry.description), badgeOf(entry.origin), sourceOf(entry),
                     titled(entry.kind)});
  show(std::move(items), tr("Bundled library"), {});
}

void LibraryController::showFolder(const QString& folder) {
  std::vector<widgets::LibraryItem> items;
  const QDir dir(folder);
  for (const QFileInfo& file : dir.entryInfoList(materialFilePatterns(), QDir::Files | QDir::Readable, QDir::Name)) {
    const materials::MaterialFormat* format = materials::formatOfFile(file.filesystemAbsoluteFilePath());
    // A suffix such as .txt is that of other files too.
    if (!format) continue;
    const std::string_view label = format->label;
    const QString kind = QString::fromUtf8(label.data(), qsizetype(label.size()));
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

void LibraryController::setReference(const QString& id) {
  if (id.isEmpty()) {
    m_tasks.drop(likenessKey);
    return m_model.setReference({});
  }
  m_tasks.run<widgets::LibraryLook>(
      {.title = tr("Rendering a thumbnail of %1").arg(id.section('/', -1)), .key = likenessKey, .quiet = true},
      [make = m_makeLook, id](const TaskControl& control) { return make(id, control); },
      [this](const widgets::LibraryLook& look) { m_model.setReference(look); },
      [this](const QString&) { m_model.setReference({}); });
}

void LibraryController::makeLargePicture(const QString& id, int pixels) {
  constexpr int samples = 32;
  m_tasks.run<QImage>(
      {.title = tr("Rendering %1").arg(id.section('/', -1)), .key = largePictureKey, .live = true},
      [id, pixels](const TaskControl& control) {
        return spherePicture(*materials::readMaterial(id.toStdString(), control).brdf, pixels, samples, control);
      },
      [this, id](const QImage& picture) { Q_EMIT largePictureMade(id, picture); }, [](const QString&) {});
}

void LibraryController::setVisible(const QStringList& ids) { m_visible = ids; }

bool LibraryController::isVisibleComplete() const {
  const QStringList pending = m_model.pending();
  return std::none_of(m_visible.begin(), m_visible.end(), [&](const QString& id) { return pending.contains(id); });
}

QStringList LibraryController::nextOnes() const {
  const QStringList pending = m_model.pending();
  QStringList ids = pending;
  std::stable_partition(ids.begin(), ids.end(), [&](const QString& id) { return m_visible.contains(id); });
  return ids;
}

void LibraryController::makeNext() {
  const QStringList ids = nextOnes();
  if (ids.isEmpty()) return;
  const double done = 1 - double(ids.size()) / m_model.materialCount();
  const QString title = tr("Rendering thumbnails: %n left", nullptr, int(ids.size()));
  m_tasks.run<std::vector<Made>>(
      {title, thumbnailKey, true},
      [make = m_makeLook, ids, done](const TaskControl& control) {
        control.report(done);
        return madeInABatch(make, ids, {control.stop, {}});
      },
      [this](const std::vector<Made>& batch) {
        for (const Made& made : batch) {
          if (made.failure.isEmpty())
            m_model.setLook(made.id, made.look);
          else
            m_model.setFailure(made.id, made.failure);
        }
        makeNext();
      });
}

}  // namespace gonio::app

#include "moc_library_controller.cpp"
