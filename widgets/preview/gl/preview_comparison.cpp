// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/preview_comparison.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace gonio::widgets {

namespace {
constexpr double rangeQuantile = 0.995, minRange = 1e-3;

struct PreviewComparisonText {
  Q_DECLARE_TR_FUNCTIONS(PreviewComparison)
};
}  // namespace

std::vector<double> pictureDifferences(const Image& first, const Image& second, DifferenceKind kind) {
  assert(first.pixels.size() == second.pixels.size());
  std::vector<double> differences;
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    if (std::max(first.alpha[i], second.alpha[i]) < 0.5f) continue;
    const double l1 = luminance(Rgb(first.pixels[i])), l2 = luminance(Rgb(second.pixels[i]));
    const double difference = l1 - l2;
    if (kind == DifferenceKind::signedValue)
      differences.push_back(difference);
    else if (kind == DifferenceKind::absolute)
      differences.push_back(std::abs(difference));
    else
      differences.push_back(std::abs(difference) / std::max(l2, minRelativeLuminance));
  }
  return differences;
}

double automaticRange(std::vector<double> differences) {
  if (differences.empty()) return minRange;
  for (double& difference : differences) difference = std::abs(difference);
  const auto at = differences.begin() + std::ptrdiff_t(rangeQuantile * double(differences.size() - 1));
  std::nth_element(differences.begin(), at, differences.end());
  if (!(*at > minRange)) return minRange;
  const double power = std::pow(10, std::floor(std::log10(*at)));
  for (const double step : {1.0, 2.0, 5.0})
    if (*at <= step * power * (1 + 1e-9)) return step * power;
  return 10 * power;
}

QString differenceTitle(DifferenceKind kind) {
  if (kind == DifferenceKind::relative) return PreviewComparisonText::tr("Luminance difference, relative [%]");
  if (kind == DifferenceKind::signedValue)
    return PreviewComparisonText::tr("Luminance difference, signed [scene radiance]");
  return PreviewComparisonText::tr("Luminance difference, absolute [scene radiance]");
}

QString differenceNumber(DifferenceKind kind, double value) {
  if (kind == DifferenceKind::relative) return QString::number(100 * value, 'g', 3);
  return QString::number(value, 'g', 3);
}

}  // namespace gonio::widgets
