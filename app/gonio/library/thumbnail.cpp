// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/thumbnail.h"

#include <QDir>
#include <QSaveFile>
#include <QStandardPaths>

#include "app/gonio/library/shipped_thumbnails.h"
#include "app/gonio/library/sphere_picture.h"
#include "core/materials/bundled_library.h"
#include "core/materials/material.h"

namespace gonio::app {

namespace {

/// Part of the cache's file names: a change of the renderer, the scene or the tone curve needs a new one.
constexpr int rendererVersion = 1;
constexpr int side = 192, samplesPerPixel = 16;

widgets::LibraryLook fromImage(const QImage& image) {
  return {image, image.text("hue").toDouble(), image.text("roughness").toDouble()};
}

}  // namespace

QString thumbnailCacheFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/thumbnails");
}

widgets::LibraryLook materialLook(const QString& id, const QString& cacheFolder, const TaskControl& control) {
  // A bundled material is not read for its hash: that would decode it.
  if (const std::string hash = materials::librarySha256(id.toStdString()); !hash.empty())
    if (const auto shipped = shippedLook(hash)) return *shipped;
  // A file has to be read for its hash; its values are parsed beside that.
  const materials::Material material = materials::readMaterial(id.toStdString(), control);
  const QString hash = QString::fromStdString(material.source.sha256);
  const QString cached = cacheFolder + QStringLiteral("/%1-%2-%3.png").arg(hash).arg(rendererVersion).arg(side);
  if (const QImage known(cached); !known.isNull()) return fromImage(known);
  const QImage image = spherePicture(*material.brdf, side, samplesPerPixel, control);
  // A cache that cannot be written costs time and nothing else.
  QDir().mkpath(cacheFolder);
  QSaveFile file(cached);
  if (file.open(QIODevice::WriteOnly) && image.save(&file, "PNG")) file.commit();
  return fromImage(image);
}

}  // namespace gonio::app
