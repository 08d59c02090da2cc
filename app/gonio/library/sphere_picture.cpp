// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/library/sphere_picture.h"

#include <algorithm>

#include "core/rendering/render_picture.h"
#include "core/rendering/tone_map.h"

namespace gonio::app {

namespace {

constexpr double exposure = 0;

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
  options.lobe = estimateSamplingDensity(brdf);
  const Image picture = renderPicture(brdf, comparisonScene(), options, control);
  QImage image = displayedImage(picture);
  image.setText("roughness", QString::number(options.lobe->roughness));
  image.setText("hue", QString::number(meanHue(image)));
  return image;
}

}  // namespace gonio::app
