// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/thumbnail.h"

#include <QDir>
#include <QFile>
#include <QPainter>
#include <QSaveFile>
#include <QStandardPaths>
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>
#include "core/io/csv_text.h"

#include "app/gonio/document/material_files.h"
#include "core/documents/open_material.h"
#include "core/io/byte_source.h"
#include "core/io/sha256.h"
#include "core/materials/bundled_library.h"
#include "core/rendering/render_picture.h"
#include "core/rendering/tone_map.h"
#include "core/support/text.h"

namespace gonio::app {

namespace {

constexpr double exposure = 0;

/// Rim lights show the outline of dark materials, which the studio leaves in the dark.
rendering::Scene thumbnailScene() { return rendering::sphereScene(rendering::bundledEnvironment("rim-lights")); }

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
  const std::vector<std::uint8_t> bytes = rendering::toDisplayBytes(picture, exposure, rendering::ToneMap::filmic);
  return QImage(bytes.data(), picture.width, picture.height, picture.width * 4, QImage::Format_RGBA8888).copy();
}

QImage spherePicture(const Brdf& brdf, int pixels, int samples, const TaskControl& control) {
  rendering::RenderOptions options;
  options.width = options.height = pixels;
  options.samples = samples;
  options.density = estimateSamplingDensity(brdf);
  const Image picture = rendering::renderPicture(brdf, thumbnailScene(), options, control);
  QImage image = displayedImage(picture);
  image.setText("roughness", QString::number(options.density->roughness));
  image.setText("hue", QString::number(meanHue(image)));
  return image;
}

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
  io::CsvWriter index;
  index.texts({"sha256", "hue", "roughness"}).endLine();
  QPainter painter(&sheet);
  int number = 0;
  for (const materials::LibraryEntry& entry : entries) {
    control.throwIfStopped();
    const materials::Material material = materials::readMaterial(std::string(materials::libraryScheme) + entry.id);
    const QImage picture = spherePicture(*material.brdf, bundledSide, bundledSamples);
    if (coverage.isNull()) coverage = picture.convertToFormat(QImage::Format_Alpha8);
    painter.drawImage(tile(number++), onMeanGround(picture));
    index.text(material.source.sha256).text(picture.text("hue").toStdString());
    index.text(picture.text("roughness").toStdString()).endLine();
  }
  painter.end();
  coverage.reinterpretAsFormat(QImage::Format_Grayscale8);
  QDir().mkpath(folder);
  writeFile(folder + QStringLiteral("/coverage.png"), [&](QIODevice& file) { return coverage.save(&file, "PNG"); });
  writeFile(folder + QStringLiteral("/bundled.jpg"),
            [&](QIODevice& file) { return sheet.save(&file, "JPG", jpegQuality); });
  const QByteArray indexBytes = QByteArray::fromStdString(index.str());
  writeFile(folder + QStringLiteral("/bundled.csv"),
            [&](QIODevice& file) { return file.write(indexBytes) == indexBytes.size(); });
}

namespace {

/// Part of the cache's file names: a change of the renderer, the scene or the tone curve needs a new one.
constexpr int rendererVersion = 2;
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
  return isDocument(id) ? documents::editedMaterial(id.toStdString(), control).shown
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
