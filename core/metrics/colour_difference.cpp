// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/colour_difference.h"

#include <cmath>

#include "core/math/srgb.h"
#include "core/metrics/image_metrics.h"
#include "core/metrics/metric_domain.h"

namespace gonio::metrics {

namespace {

/// x^7 / (x^7 + 25^7), under a root.
double seventhPowerRatio(double x) {
  const double power = std::pow(x, 7);
  return std::sqrt(power / (power + std::pow(25.0, 7)));
}

/// Hue in [0, 2 pi); 0 for a grey.
double hueAngle(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double angle = std::atan2(b, a);
  return angle < 0 ? angle + 2 * pi : angle;
}

/// Lightness, chroma and hue with the a* that CIEDE2000 stretches for greys (eq. 5-7).
struct StretchedColour {
  double lightness, chroma, hue;
};

StretchedColour stretched(const glm::dvec3& lab, double meanChroma) {
  const double a = (1 + 0.5 * (1 - seventhPowerRatio(meanChroma))) * lab.y;
  return {lab.x, std::hypot(a, lab.z), hueAngle(a, lab.z)};
}

/// The difference of hue angles on the shorter arc (eq. 10), and their mean on it (eq. 14).
struct HuePair {
  double difference, mean;
};

HuePair huePair(const StretchedColour& a, const StretchedColour& b) {
  if (a.chroma * b.chroma == 0) return {0, a.hue + b.hue};
  const double difference = b.hue - a.hue, sum = a.hue + b.hue;
  if (std::abs(difference) <= pi) return {difference, sum / 2};
  return {difference > 0 ? difference - 2 * pi : difference + 2 * pi, (sum < 2 * pi ? sum + 2 * pi : sum - 2 * pi) / 2};
}

}  // namespace

double ciede2000(const glm::dvec3& labA, const glm::dvec3& labB) {
  const double meanChromaAb = 0.5 * (std::hypot(labA.y, labA.z) + std::hypot(labB.y, labB.z));
  const StretchedColour a = stretched(labA, meanChromaAb), b = stretched(labB, meanChromaAb);
  const HuePair hue = huePair(a, b);
  const double lightness = b.lightness - a.lightness, chroma = b.chroma - a.chroma,
               hueDifference = 2 * std::sqrt(a.chroma * b.chroma) * std::sin(hue.difference / 2);
  const double meanLightness = 0.5 * (a.lightness + b.lightness), meanChroma = 0.5 * (a.chroma + b.chroma);
  const double t = 1 - 0.17 * std::cos(hue.mean - radians(30)) + 0.24 * std::cos(2 * hue.mean) +
                   0.32 * std::cos(3 * hue.mean + radians(6)) - 0.20 * std::cos(4 * hue.mean - radians(63));
  const double offBlue = (degrees(hue.mean) - 275) / 25, rotation = radians(30) * std::exp(-offBlue * offBlue);
  const double fromGrey = (meanLightness - 50) * (meanLightness - 50);
  const double scaleL = 1 + 0.015 * fromGrey / std::sqrt(20 + fromGrey), scaleC = 1 + 0.045 * meanChroma,
               scaleH = 1 + 0.015 * meanChroma * t;
  const double interaction = -std::sin(2 * rotation) * 2 * seventhPowerRatio(meanChroma);
  const double l = lightness / scaleL, c = chroma / scaleC, h = hueDifference / scaleH;
  return std::sqrt(l * l + c * c + h * h + interaction * c * h);
}

double meanColourDifference(const Image& reference, const Image& test) {
  checkEqualSizes(reference, test);
  double sum = 0;
  // labOf() takes the perfect diffuser, 1 / pi, as white.
  for (std::size_t i = 0; i < reference.pixels.size(); ++i)
    sum += ciede2000(labOf(displayed(Rgb(reference.pixels[i])) / pi), labOf(displayed(Rgb(test.pixels[i])) / pi));
  return sum / double(reference.pixels.size());
}

}  // namespace gonio::metrics
