// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/thumbnail_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/metrics/metric_domain.h"
#include "core/rendering/tone_map.h"

namespace gonio::widgets {

namespace {

constexpr double deltaEOfAnOctave = 10, minRoughness = 0.005;

const std::array<double, 256>& linearOfByte() {
  static const std::array<double, 256> table = [] {
    std::array<double, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = fromSrgb(double(i) / 255);
    return values;
  }();
  return table;
}

}  // namespace

Rgb meanLab(const QImage& picture) {
  const QImage pixels = picture.convertToFormat(QImage::Format_RGBA8888);
  const std::array<double, 256>& linear = linearOfByte();
  Rgb sum(0);
  double count = 0;
  for (int y = 0; y < pixels.height(); ++y) {
    const uchar* row = pixels.constScanLine(y);
    for (int x = 0; x < pixels.width(); ++x, row += 4)
      if (row[3] == 255) {
        sum += Rgb(linear[row[0]], linear[row[1]], linear[row[2]]);
        ++count;
      }
  }
  // A white pixel is as bright as the perfect diffuser.
  return metrics::labOf(sum / (std::max(1.0, count) * pi));
}

double dissimilarity(const Rgb& lab, double roughness, const Rgb& otherLab, double otherRoughness) {
  const double octaves = std::log2(std::max(roughness, minRoughness) / std::max(otherRoughness, minRoughness));
  return std::hypot(glm::distance(lab, otherLab), deltaEOfAnOctave * octaves);
}

}  // namespace gonio::widgets
