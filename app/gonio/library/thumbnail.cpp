// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/thumbnail.h"

#include <QDir>
#include <QSaveFile>
#include <QStandardPaths>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "app/gonio/document/material_files.h"
#include "app/gonio/library/bundled_thumbnails.h"
#include "app/gonio/library/sphere_picture.h"
#include "core/documents/open_material.h"
#include "core/io/byte_source.h"
#include "core/io/sha256.h"
#include "core/materials/bundled_library.h"
#include "core/support/number_text.h"

namespace gonio::app {

namespace {

/// Part of the cache's file names: a change of the renderer, the scene or the tone curve needs a new one.
constexpr int rendererVersion = 1;
constexpr int side = 192, samplesPerPixel = 16;

/// What names a picture in the cache: the bytes that the material is made of.
QString cacheName(const QString& id, const materials::Material& material) {
  const std::string source = material.source.sha256;
  // The edits of a document are in its own bytes.
  return QString::fromStdString(isDocument(id) ? io::sha256Hex(source + io::sha256Hex(io::FileSource(id.toStdString())))
                                               : source);
}

/// Runs work that a list of materials does for each of them, which must not wait for one for ever.
template <class Work>
auto withinTime(std::chrono::milliseconds limit, const TaskControl& control, const Work& work) {
  std::stop_source stop;
  const std::stop_callback passOn(control.stop, [&] { stop.request_stop(); });
  std::atomic<bool> isLate = false;
  const std::jthread timer([&](const std::stop_token& done) {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any ended;
    ended.wait_for(lock, done, limit, [] { return false; });
    if (done.stop_requested()) return;
    isLate = true;
    stop.request_stop();
  });
  try {
    return work(TaskControl{stop.get_token(), control.progress});
  } catch (const Cancelled&) {
    control.throwIfStopped();
    if (!isLate) throw;
    throw TooSlow("no thumbnail: it takes longer than " + numberText(double(limit.count()) / 1000) + " s to render");
  }
}

widgets::LibraryThumbnail fromImage(const QImage& image) {
  return {image, image.text("hue").toDouble(), image.text("roughness").toDouble()};
}

/// Of a file, which has to be read for its hash; its values are parsed beside that.
widgets::LibraryThumbnail renderedThumbnail(const QString& id, const QString& cacheFolder, const TaskControl& control) {
  const materials::Material material = libraryMaterial(id, control);
  const QString cached =
      cacheFolder + QStringLiteral("/%1-%2-%3.png").arg(cacheName(id, material)).arg(rendererVersion).arg(side);
  if (const QImage known(cached); !known.isNull()) return fromImage(known);
  const QImage image = spherePicture(*material.brdf, side, samplesPerPixel, control);
  // A cache that cannot be written costs time and nothing else.
  QDir().mkpath(cacheFolder);
  QSaveFile file(cached);
  if (file.open(QIODevice::WriteOnly) && image.save(&file, "PNG")) file.commit();
  return fromImage(image);
}

}  // namespace

QString thumbnailCacheFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/thumbnails");
}

QString ownMaterialsFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/materials");
}

materials::Material libraryMaterial(const QString& id, const TaskControl& control) {
  return isDocument(id) ? editing::editedMaterial(id.toStdString(), control).shown
                        : materials::readMaterial(id.toStdString(), control);
}

widgets::LibraryThumbnail materialThumbnail(const QString& id, const QString& cacheFolder, const TaskControl& control,
                                            std::chrono::milliseconds limit) {
  // A bundled material is not read for its hash: that would decode it.
  if (const std::string hash = materials::librarySha256(id.toStdString()); !hash.empty())
    if (const auto bundled = bundledThumbnail(hash)) return *bundled;
  return withinTime(limit, control,
                    [&](const TaskControl& limited) { return renderedThumbnail(id, cacheFolder, limited); });
}

}  // namespace gonio::app
