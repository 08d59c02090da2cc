// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/library_controller.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <chrono>
#include <iterator>

#include "app/gonio/document/material_files.h"
#include "app/gonio/library/thumbnail.h"
#include "core/materials/material_formats.h"

namespace gonio::app {

namespace {

const QString thumbnailKey = QStringLiteral("thumbnail"), similarityKey = QStringLiteral("library-similarity"),
              largePictureKey = QStringLiteral("library-large-picture"), folderKey = QStringLiteral("library-folder");

/// A picture, or why there is none.
struct Made {
  QString id;
  widgets::LibraryThumbnail thumbnail;
  QString failure, badge;
};

/// The first of the pictures: as many as take a tenth of a second. One at a time would wait for a frame of the preview
/// each.
std::vector<Made> madeInABatch(const LibraryController::ThumbnailFactory& make, const QStringList& ids,
                               const TaskControl& control) {
  constexpr std::chrono::milliseconds batchTime(100);
  const auto start = std::chrono::steady_clock::now();
  std::vector<Made> batch;
  for (const QString& id : ids) {
    Made& made = batch.emplace_back(Made{id, {}, {}, {}});
    try {
      made.thumbnail = make(id, control);
    } catch (const Cancelled&) {
      throw;
    } catch (const TooSlow& error) {
      made.badge = LibraryController::tr("too slow");
      made.failure = QString::fromStdString(error.what());
    } catch (const std::exception& error) {
      made.badge = LibraryController::tr("cannot be read");
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
      return LibraryController::tr("close copy");
    default:
      return LibraryController::tr("model fit");
  }
}

QString badgeMeaning(materials::LibraryOrigin origin) {
  switch (origin) {
    case materials::LibraryOrigin::measured:
      return LibraryController::tr("Measured: the values of a goniophotometer.");
    case materials::LibraryOrigin::nearMeasured:
      return LibraryController::tr(
          "Close copy: a neural network fitted to a measurement, smoother than the measurement.");
    default:
      return LibraryController::tr(
          "Model fit: parameters of a model fitted to a measurement, as published in a paper; the coarsest quality.");
  }
}

QString sourceOf(const materials::LibraryEntry& entry) {
  const QString prefix = QString::fromStdString(entry.id.substr(0, entry.id.find('/')));
  switch (entry.origin) {
    case materials::LibraryOrigin::measured:
      return LibraryController::tr("Measured: RGL");
    case materials::LibraryOrigin::nearMeasured:
      return LibraryController::tr("Close copies: %1").arg(prefix.section('-', 0, 0).toUpper());
    default:
      return LibraryController::tr("Model fits: MERL");
  }
}

QString titled(const std::string& kind) {
  QString title = QString::fromStdString(kind);
  if (!title.isEmpty()) title[0] = title[0].toUpper();
  return title;
}

/// What the qualities of one material have in common: "merl/chrome" for "merl-copy/chrome" and "sgd/chrome".
QString materialOf(const materials::LibraryEntry& entry) {
  const std::string_view source = std::string_view(entry.id).substr(0, entry.id.find('/'));
  std::string_view database = source.substr(0, source.find('-'));
  if (source == materials::sgdSource) database = "merl";
  return QString::fromStdString(std::string(database) + '/' + entry.name);
}

std::vector<widgets::LibraryItem> bundledItems() {
  std::vector<widgets::LibraryItem> items;
  for (const materials::LibraryEntry& entry : materials::bundledLibrary())
    items.push_back({.id = QString::fromStdString("library:" + entry.id),
                     .name = QString::fromStdString(entry.name),
                     .toolTip = QString::fromStdString(entry.description),
                     .badge = badgeOf(entry.origin),
                     .source = sourceOf(entry),
                     .kind = titled(entry.kind),
                     .badgeMeaning = badgeMeaning(entry.origin),
                     .material = materialOf(entry)});
  return items;
}

/// The format of a file that is a material or a document; empty for others.
QString formatLabel(const QFileInfo& file) {
  if (isDocument(file.fileName())) return LibraryController::tr("Gonio document");
  // Each file is looked into: a suffix such as .txt is that of other files too.
  const materials::MaterialFormat* format = materials::formatOfFile(file.filesystemAbsoluteFilePath());
  return format ? QString::fromUtf8(format->label.data(), qsizetype(format->label.size())) : QString();
}

/// @param source the heading of all of them
std::vector<widgets::LibraryItem> materialsIn(const QString& folder, const QString& source,
                                              const TaskControl& control) {
  std::vector<widgets::LibraryItem> items;
  const QStringList patterns = materialFilePatterns() + QStringList{'*' + documentSuffix()};
  for (const QFileInfo& file : QDir(folder).entryInfoList(patterns, QDir::Files | QDir::Readable, QDir::Name)) {
    control.throwIfStopped();
    const QString format = formatLabel(file);
    if (format.isEmpty()) continue;
    items.push_back({.id = file.absoluteFilePath(),
                     .name = file.completeBaseName(),
                     .toolTip = LibraryController::tr("%1, %2").arg(format, file.fileName()),
                     .badge = isDocument(file.fileName()) ? LibraryController::tr("edited") : QString(),
                     .source = source,
                     .version = file.lastModified().toMSecsSinceEpoch()});
  }
  return items;
}

}  // namespace

LibraryController::LibraryController(BackgroundTasks& tasks, ThumbnailFactory makeThumbnail, QString ownFolder,
                                     QObject* parent)
    : QObject(parent), m_tasks(tasks), m_makeThumbnail(std::move(makeThumbnail)), m_ownFolder(std::move(ownFolder)) {
  // While a file is written its folder changes many times.
  constexpr int quietMilliseconds = 500;
  m_change.setSingleShot(true);
  m_change.setInterval(quietMilliseconds);
  connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_change, qOverload<>(&QTimer::start));
  connect(&m_change, &QTimer::timeout, this, &LibraryController::listFolder);
}

void LibraryController::showBundled() {
  begin(tr("Bundled library"), {});
  show(bundledItems());
  listOwn();
}

void LibraryController::addOwn(const QString& path) {
  listOwn();
  Q_EMIT added(path);
}

void LibraryController::listOwn() {
  if (!m_folder.isEmpty() || m_ownFolder.isEmpty()) return;
  watch(m_ownFolder);
  listFolder();
}

void LibraryController::showFolder(const QString& folder) {
  begin(QDir(folder).dirName(), folder);
  watch(folder);
  m_model.beginListing();
  listFolder();
}

void LibraryController::watch(const QString& folder) {
  if (QDir(folder).exists() && !m_watcher.directories().contains(folder)) m_watcher.addPath(folder);
}

void LibraryController::begin(const QString& title, const QString& folder) {
  m_tasks.drop(folderKey);
  m_change.stop();
  if (!m_watcher.directories().isEmpty()) m_watcher.removePaths(m_watcher.directories());
  m_title = title;
  m_folder = folder;
  m_visible.clear();
  Q_EMIT titleChanged(m_title);
}

void LibraryController::listFolder() {
  m_tasks.run<std::vector<widgets::LibraryItem>>(
      {.title = tr("Listing %1").arg(m_title), .key = folderKey, .quiet = true},
      [folder = m_folder, own = m_ownFolder](const TaskControl& control) {
        if (!folder.isEmpty()) return materialsIn(folder, {}, control);
        std::vector<widgets::LibraryItem> items = materialsIn(own, tr("User materials"), control);
        std::ranges::move(bundledItems(), std::back_inserter(items));
        return items;
      },
      [this](std::vector<widgets::LibraryItem> items) { show(std::move(items)); });
}

void LibraryController::show(std::vector<widgets::LibraryItem> items) {
  m_tasks.drop(thumbnailKey);
  m_model.setItems(std::move(items));
  makeNext();
}

void LibraryController::setReference(const QString& id) {
  if (id.isEmpty()) {
    m_tasks.drop(similarityKey);
    return m_model.setReference({});
  }
  m_tasks.run<widgets::LibraryThumbnail>(
      {.title = tr("Rendering a thumbnail of %1").arg(shortName(id)), .key = similarityKey, .quiet = true},
      [make = m_makeThumbnail, id](const TaskControl& control) { return make(id, control); },
      [this](const widgets::LibraryThumbnail& thumbnail) { m_model.setReference(thumbnail); },
      [this](const QString&) { m_model.setReference({}); });
}

void LibraryController::makeLargePicture(const QString& id, int pixels) {
  constexpr int samples = 32;
  m_tasks.run<QImage>(
      {.title = tr("Rendering %1").arg(shortName(id)), .key = largePictureKey, .live = true},
      [id, pixels](const TaskControl& control) {
        return spherePicture(*libraryMaterial(id, control).brdf, pixels, samples, control);
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
      [make = m_makeThumbnail, ids, done](const TaskControl& control) {
        control.report(done);
        return madeInABatch(make, ids, {control.stop, {}});
      },
      [this](const std::vector<Made>& batch) {
        for (const Made& made : batch) {
          if (made.failure.isEmpty())
            m_model.setThumbnail(made.id, made.thumbnail);
          else
            m_model.setFailure(made.id, made.failure, made.badge);
        }
        makeNext();
      });
}

}  // namespace gonio::app

#include "moc_library_controller.cpp"
