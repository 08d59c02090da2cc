// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/matching/reference_image.h"

#include <QColorSpace>
#include <QFileInfo>
#include <QImageReader>
#include <algorithm>
#include <string>

#include "core/io/image_io.h"
#include "core/math/colour.h"
#include "core/support/error.h"

namespace gonio::app {

namespace {

constexpr const char* radianceSuffixes[] = {"exr", "hdr"};

bool isRadianceFile(const QString& path) {
  const std::string suffix = QFileInfo(path).suffix().toLower().toStdString();
  return std::ranges::any_of(radianceSuffixes, [&](const char* one) { return suffix == one; });
}

QImage displayed(const Image& image) {
  const auto bytes = rendering::toDisplayBytes(image, 0, rendering::ToneMap::clamp);
  return QImage(bytes.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
}

/// Display values, linear. The colours are premultiplied as in all images of core.
Image linearValues(const QImage& image) {
  const QImage straight = image.convertToFormat(QImage::Format_RGBA64);
  Image values(image.width(), image.height());
  if (image.hasAlphaChannel()) values.alpha.resize(values.pixels.size());
  for (int y = 0; y < values.height; ++y) {
    const auto* row = reinterpret_cast<const QRgba64*>(straight.constScanLine(y));
    for (int x = 0; x < values.width; ++x) {
      constexpr double full = 65535;
      const double alpha = row[x].alpha() / full;
      values.at(x, y) = glm::vec3(alpha * fromSrgb(row[x].red() / full), alpha * fromSrgb(row[x].green() / full),
                                  alpha * fromSrgb(row[x].blue() / full));
      if (!values.alpha.empty()) values.alpha[values.index(x, y)] = float(alpha);
    }
  }
  return values;
}

}  // namespace

bool isReferenceImageFile(const QString& path) {
  return QImageReader::supportedImageFormats().contains(QFileInfo(path).suffix().toLower().toLatin1()) &&
         !isRadianceFile(path);
}

QString referenceImagePatterns() {
  QStringList patterns;
  for (const QByteArray& suffix : QImageReader::supportedImageFormats())
    patterns << QStringLiteral("*.") + QString::fromLatin1(suffix);
  for (const char* suffix : radianceSuffixes) patterns << QStringLiteral("*.%1").arg(suffix);
  return patterns.join(' ');
}

matching::ReferencePicture ReferenceImage::picture(ImageTones tones, double exposure) const {
  if (isRadiance) return {values, disc};
  // The largest value of a file with 8 bits stands for all above.
  constexpr double clipped = 254.5 / 255;
  const bool isRendered = tones != ImageTones::photograph;
  const auto toneMap = tones == ImageTones::filmic ? rendering::ToneMap::filmic : rendering::ToneMap::clamp;
  const auto radiance = [&](double display) {
    return rendering::radianceOf(std::min(1.0, display), isRendered ? exposure : 0, toneMap);
  };
  matching::ReferencePicture result{values, disc, radiance(fromSrgb(clipped))};
  for (glm::vec3& pixel : result.image.pixels)
    for (int c = 0; c < 3; ++c) pixel[c] = float(radiance(pixel[c]));
  return result;
}

ReferenceImage readReferenceImage(const QString& path) {
  ReferenceImage image{.path = path, .isRadiance = isRadianceFile(path)};
  if (image.isRadiance) {
    image.values = io::readImage(path.toStdString());
    image.shown = displayed(image.values);
  } else {
    QImageReader reader(path);
    reader.setAutoTransform(true);
    image.shown = reader.read();
    if (image.shown.isNull()) throw Error(path.toStdString() + ": " + reader.errorString().toStdString());
    if (image.shown.colorSpace().isValid()) image.shown.convertToColorSpace(QColorSpace::SRgb);
    image.values = linearValues(image.shown);
  }
  const double width = image.values.width, height = image.values.height;
  image.disc = {width / 2, height / 2, std::max(1.0, 0.45 * std::min(width, height))};
  try {
    image.found = matching::findSphere(image.values);
    image.disc = *image.found;
  } catch (const Error&) {
    // The user draws the circle.
  }
  return image;
}

}  // namespace gonio::app
