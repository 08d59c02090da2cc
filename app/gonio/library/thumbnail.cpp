// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/thumbnail.h"

#include <QDir>
#include <QSaveFile>
#include <QStandardPaths>
#include <cmath>

#include "app/gonio/library/shipped_thumbnails.h"
#include "core/materials/bundled_library.h"
#include "core/materials/material.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/tone_map.h"

namespace gonio::app {

namespace {

/// Part of the cache's file names: a change of the renderer, the scene or the tone curve needs a new one.
constexpr int rendererVersion = 1;
constexpr int side = 192, samplesPerPixel = 16;
constexpr double exposure = 0;

widgets::LibraryLook fromImage(const QImage& image) {
  return {image, image.text("hue").toDouble(), image.text("roughness").toDouble()};
}

/// Hue of the mean colour in degrees; -1 for a grey.
double meanHue(const QImage& image) {
  double red = 0, green = 0, blue = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QRgb pixel = image.pixel(x, y);
      if (qAlpha(pixel) < 255) continue;
      red += qRed(pixel), green += qGreen(pixel), blue += qBlue(pixel);
    }
  const double scale = 1 / std::max({red, green, blue, 1.0});
  const QColor mean = QColor::fromRgbF(float(red * scale), float(green * scale), float(blue * scale));
  constexpr float greySaturation = 0.04f;
  return mean.saturationF() < greySaturation ? -1 : mean.hueF() * 360.0;
}

}  // namespace

QImage displayedImage(const Image& picture) {
  const std::vector<std::uint8_t> bytes = toDisplayBytes(picture, exposure, ToneMap::filmic);
  return QImage(bytes.data(), picture.width, picture.height, picture.width * 4, QImage::Format_RGBA8888).copy();
}

QImage spherePicture(const Brdf& brdf, int pixels, int samples, const TaskControl& control) {
  RenderOptions options;
  options.width = options.height = pixels;
  options.samples = samples;
  options.lobe = estimateSamplingLobe(brdf);
  const Image picture = renderPicture(brdf, comparisonScene(), options, control);
  QImage image = displayedImage(picture);
  image.setText("roughness", QString::number(options.lobe->roughness));
  image.setText("hue", QString::number(meanHue(image)));
  return image;
}

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
