// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/bundled_thumbnails.h"

#include <QDir>
#include <QFile>
#include <QPainter>
#include <QSaveFile>
#include <map>

#include "app/gonio/library/sphere_picture.h"
#include "core/materials/bundled_library.h"

namespace gonio::app {

namespace {

constexpr int columns = 12;
/// JPEG quality: at 92 the mean error is below one level of 256, in a fifth of the bytes of PNG.
constexpr int jpegQuality = 92;

QRect tile(int index) {
  return {index % columns * bundledSide, index / columns * bundledSide, bundledSide, bundledSide};
}

struct Shipped {
  QImage sheet, coverage;
  struct Tile {
    int index;
    double hue, roughness;
  };
  std::map<std::string, Tile> tiles;  ///< by SHA-256
};

Shipped readShipped() {
  Shipped shipped{QImage(QStringLiteral(":/thumbnails/bundled.jpg")).convertToFormat(QImage::Format_RGB32),
                  QImage(QStringLiteral(":/thumbnails/coverage.png")).convertToFormat(QImage::Format_Grayscale8),
                  {}};
  QFile index(QStringLiteral(":/thumbnails/bundled.csv"));
  if (!index.open(QIODevice::ReadOnly)) return shipped;
  index.readLine();  // the header
  for (int number = 0; !index.atEnd(); ++number) {
    const QList<QByteArray> fields = index.readLine().trimmed().split(',');
    if (fields.size() == 3)
      shipped.tiles[fields[0].toStdString()] = {number, fields[1].toDouble(), fields[2].toDouble()};
  }
  return shipped;
}

QImage withCoverage(const QImage& colour, const QImage& coverage) {
  QImage picture = colour.convertToFormat(QImage::Format_ARGB32);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QRgb pixel = picture.pixel(x, y);
      const int alpha = coverage.constScanLine(y)[x];
      picture.setPixel(x, y, alpha == 0 ? 0 : qRgba(qRed(pixel), qGreen(pixel), qBlue(pixel), alpha));
    }
  return picture;
}

/// The ground takes the mean colour of the sphere, so that JPEG has no hard edge to soften.
QImage onMeanGround(const QImage& picture) {
  double red = 0, green = 0, blue = 0, weight = 1e-9;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QRgb pixel = picture.pixel(x, y);
      const double alpha = qAlpha(pixel);
      red += alpha * qRed(pixel), green += alpha * qGreen(pixel), blue += alpha * qBlue(pixel), weight += alpha;
    }
  const QRgb mean = qRgb(int(red / weight), int(green / weight), int(blue / weight));
  QImage opaque(picture.size(), QImage::Format_RGB32);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QRgb pixel = picture.pixel(x, y);
      opaque.setPixel(x, y, qAlpha(pixel) == 0 ? mean : qRgb(qRed(pixel), qGreen(pixel), qBlue(pixel)));
    }
  return opaque;
}

void writeFile(const QString& path, const std::function<bool(QIODevice&)>& write) {
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly) || !write(file) || !file.commit())
    throw Error(path.toStdString() + ": cannot be written: " + file.errorString().toStdString());
}

}  // namespace

std::optional<widgets::LibraryThumbnail> bundledThumbnail(const std::string& sha256) {
  static const Shipped shipped = readShipped();
  const auto found = shipped.tiles.find(sha256);
  if (found == shipped.tiles.end()) return std::nullopt;
  const auto& [index, hue, roughness] = found->second;
  return widgets::LibraryThumbnail{withCoverage(shipped.sheet.copy(tile(index)), shipped.coverage), hue, roughness};
}

void writeBundledThumbnails(const QString& folder, const TaskControl& control) {
  const auto& entries = materials::bundledLibrary();
  QImage sheet(columns * bundledSide, ((int(entries.size()) + columns - 1) / columns) * bundledSide,
               QImage::Format_RGB32);
  sheet.fill(Qt::black);
  QImage coverage;
  QByteArray index = "sha256,hue,roughness\n";
  QPainter painter(&sheet);
  int number = 0;
  for (const materials::LibraryEntry& entry : entries) {
    control.throwIfStopped();
    const materials::Material material = materials::readMaterial(std::string(materials::libraryScheme) + entry.id);
    const QImage picture = spherePicture(*material.brdf, bundledSide, bundledSamples);
    if (coverage.isNull()) coverage = picture.convertToFormat(QImage::Format_Alpha8);
    painter.drawImage(tile(number++), onMeanGround(picture));
    index += QByteArray::fromStdString(material.source.sha256) + ',' + picture.text("hue").toLatin1() + ',' +
             picture.text("roughness").toLatin1() + '\n';
  }
  painter.end();
  coverage.reinterpretAsFormat(QImage::Format_Grayscale8);
  QDir().mkpath(folder);
  writeFile(folder + QStringLiteral("/coverage.png"), [&](QIODevice& file) { return coverage.save(&file, "PNG"); });
  writeFile(folder + QStringLiteral("/bundled.jpg"),
            [&](QIODevice& file) { return sheet.save(&file, "JPG", jpegQuality); });
  writeFile(folder + QStringLiteral("/bundled.csv"),
            [&](QIODevice& file) { return file.write(index) == index.size(); });
}

}  // namespace gonio::app
