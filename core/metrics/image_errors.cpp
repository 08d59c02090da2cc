// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/image_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "core/math/colour.h"
#include "core/math/image.h"
#include "core/math/parallel.h"
#include "core/metrics/brdf_metric.h"
#include "core/metrics/image_metrics.h"

namespace gonio::metrics {

namespace {

/// One number per pixel of a picture, row-major.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<double> values;
};

/// function(pixel) for every pixel, with the radiance as double.
template <typename Function>
Plane planeOf(const Image& image, const Function& function) {
  Plane plane{.width = image.width, .height = image.height, .values = std::vector<double>(image.pixels.size())};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) plane.values[i] = function(Rgb(image.pixels[i]));
  return plane;
}

/// Correlation along one axis: `count` pixels per line, `step` apart; line l starts at start(l).
template <typename Start>
Plane filteredLines(const Plane& plane, std::span<const double> kernel, int lines, int count, int step, Start start) {
  const int radius = int(kernel.size()) / 2;
  Plane result{.width = plane.width, .height = plane.height, .values = std::vector<double>(plane.values.size())};
  parallelForBlocks(std::size_t(lines), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t line = begin; line < end; ++line)
      for (int i = 0; i < count; ++i) {
        double sum = 0;
        for (int k = -radius; k <= radius; ++k)
          sum += kernel[std::size_t(k + radius)] *
                 plane.values[start(line) + std::size_t(std::clamp(i + k, 0, count - 1)) * std::size_t(step)];
        result.values[start(line) + std::size_t(i) * std::size_t(step)] = sum;
      }
  });
  return result;
}

/// Correlation with the separable kernel column(y) row(x); pixels beyond the border have the value of the nearest
/// pixel. Parallel; results do not depend on the number of threads. @param row, column weights of an odd number of
/// pixels, centred at the pixel.
Plane filtered(const Plane& plane, std::span<const double> row, std::span<const double> column) {
  const auto width = std::size_t(plane.width);
  const Plane rows = filteredLines(plane, row, plane.height, plane.width, 1, [&](std::size_t y) { return y * width; });
  return filteredLines(rows, column, plane.width, plane.height, plane.width, [](std::size_t x) { return x; });
}

/// exp(-x^2 / (2 deviation^2)) for x = -radius, .., radius, divided by its sum. @param deviation standard deviation in
/// pixels, > 0.
std::vector<double> gaussianKernel(int radius, double deviation) {
  std::vector<double> weights;
  for (int x = -radius; x <= radius; ++x) weights.push_back(std::exp(-0.5 * x * x / (deviation * deviation)));
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= sum;
  return weights;
}

constexpr std::string_view linearDomain = "linear radiance", displayDomain = "displayed: clamped to [0, 1]";

constexpr ImageMetricRecord imageRecords[] = {
    {"mse", "MSE", linearDomain, "mean((r - t)^2), r: reference, t: test image", "mean squared error",
     meanSquaredError},
    {"log-mse", "log MSE", linearDomain, "mean((ln(1 + r) - ln(1 + t))^2), r: reference, t: test image",
     "mean squared error of the logarithm", meanSquaredLogError},
    {"relative-mse", "relative MSE", linearDomain, "mean((r - t)^2 / (r^2 + 0.01)), r: reference, t: test image",
     "after Rousselle, Knaus and Zwicker 2011, Adaptive Sampling and Reconstruction using Greedy Error "
     "Minimization",
     relativeMeanSquaredError},
    {"ssim", "SSIM", "luminance, clamped to [0, 1], encoded as sRGB",
     "mean((2 mu_r mu_t + C_1)(2 sigma_rt + C_2) / ((mu_r^2 + mu_t^2 + C_1)(sigma_r^2 + sigma_t^2 + C_2))); mu, "
     "sigma^2 and sigma_rt: local means, variances and covariance of the reference r and the test image t, "
     "C_1 = 0.01^2, C_2 = 0.03^2",
     "Wang, Bovik, Sheikh and Simoncelli 2004, Image Quality Assessment: From Error Visibility to Structural "
     "Similarity",
     structuralSimilarity, true},
    {"flip", "FLIP", displayDomain, "mean(colour error^(1 - feature error))",
     "Andersson et al. 2020, FLIP: A Difference Evaluator for Alternating Images", flip},
    {"ciede2000", "CIEDE2000", displayDomain, "mean(Delta E_00)",
     "Sharma, Wu and Dalal 2005, The CIEDE2000 Color-Difference Formula", meanColourDifference},
};

}  // namespace

std::span<const ImageMetricRecord> imageMetricRecords() { return imageRecords; }

std::vector<double> imageErrors(const Image& reference, const Image& test) {
  std::vector<double> errors;
  for (const ImageMetricRecord& record : imageRecords) errors.push_back(record.compute(reference, test));
  return errors;
}

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

namespace {

using Planes = std::array<Plane, 3>;

/// One Gaussian of a contrast sensitivity function: its weight and the b of exp(-(pi x)^2 / b), x in degrees.
struct SensitivityLobe {
  double a, b;
};

/// Opponent colours Y, Cx, Cz, which are linear in the radiance (the paper, section 4.1).
Rgb opponent(const Rgb& xyz) { return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)}; }
Rgb fromOpponent(const Rgb& c) {
  const double y = (c.x + 16) / 116;
  return {y + c.y / 500, y, y - c.z / 200};
}

Planes opponentPlanes(const Image& image) {
  Planes planes;
  for (int channel = 0; channel < 3; ++channel)
    planes[std::size_t(channel)] = planeOf(image, [channel](const Rgb& radiance) {
      const Rgb shown = displayed(radiance);
      return opponent(whiteRelativeXyz(shown.x, shown.y, shown.z))[channel];
    });
  return planes;
}

/// The plane as the eye resolves it: the sum of its Gaussians, of which each is separable, divided by the sum of all
/// weights.
Plane resolved(const Plane& plane, std::initializer_list<SensitivityLobe> lobes) {
  constexpr double widestB = 0.04;
  const int radius = int(std::ceil(3 * std::sqrt(widestB / (2 * pi * pi)) * flipPixelsPerDegree));
  Plane sum{.width = plane.width, .height = plane.height, .values = std::vector<double>(plane.values.size(), 0)};
  double total = 0;
  for (const SensitivityLobe& lobe : lobes) {
    std::vector<double> kernel;
    for (int x = -radius; x <= radius; ++x)
      kernel.push_back(std::exp(-std::pow(pi * x / flipPixelsPerDegree, 2) / lobe.b));
    const double weight = lobe.a * std::sqrt(pi / lobe.b);
    total += weight * std::pow(std::accumulate(kernel.begin(), kernel.end(), 0.0), 2);
    const Plane part = filtered(plane, kernel, kernel);
    for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += weight * part.values[i];
  }
  for (double& value : sum.values) value /= total;
  return sum;
}

/// CIELAB with chroma scaled by lightness (Hunt), of linear sRGB.
Rgb huntLab(const Rgb& linear) {
  const Rgb lab = labOf(linear / pi);  // white is the perfect diffuser
  return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

std::vector<Rgb> resolvedColours(const Planes& planes) {
  const glm::dmat3 toXyz(whiteRelativeXyz(1, 0, 0), whiteRelativeXyz(0, 1, 0), whiteRelativeXyz(0, 0, 1));
  const glm::dmat3 toRgb = glm::inverse(toXyz);
  const Plane y = resolved(planes[0], {{1, 0.0047}}), x = resolved(planes[1], {{1, 0.0053}}),
              z = resolved(planes[2], {{34.1, 0.04}, {13.5, 0.025}});
  std::vector<Rgb> colours;
  for (std::size_t i = 0; i < y.values.size(); ++i)
    colours.push_back(huntLab(displayed(toRgb * fromOpponent({y.values[i], x.values[i], z.values[i]}))));
  return colours;
}

/// HyAB distance to the power 0.7.
double colourDistance(const Rgb& a, const Rgb& b) {
  const Rgb d = a - b;
  return std::pow(std::abs(d.x) + std::hypot(d.y, d.z), 0.7);
}

/// The colour difference in [0, 1]: 0.95 at 0.4 of the distance between green and blue, the largest of all (4.1.3).
double colourError(double distance) {
  static const double largest = colourDistance(huntLab({0, 1, 0}), huntLab({0, 0, 1}));
  constexpr double bend = 0.4, errorAtBend = 0.95;
  const double edge = bend * largest;
  if (distance < edge) return errorAtBend / edge * distance;
  return errorAtBend + (distance - edge) / (largest - edge) * (1 - errorAtBend);
}

/// Divides the positive weights by their sum, and the negative ones by theirs.
void normaliseSigns(std::vector<double>& kernel) {
  double positive = 0, negative = 0;
  for (const double weight : kernel) (weight > 0 ? positive : negative) += std::abs(weight);
  for (double& weight : kernel) weight /= weight > 0 ? positive : negative;
}

/// Strength of edges and of points in the achromatic plane (section 4.2).
struct FeatureStrengths {
  std::vector<double> edges, points;
};

std::vector<double> strengths(const Plane& plane, const std::vector<double>& derivative,
                              const std::vector<double>& smooth) {
  const Plane x = filtered(plane, derivative, smooth), y = filtered(plane, smooth, derivative);
  std::vector<double> result;
  for (std::size_t i = 0; i < x.values.size(); ++i) result.push_back(std::hypot(x.values[i], y.values[i]));
  return result;
}

FeatureStrengths features(Plane achromatic) {
  for (double& value : achromatic.values) value = (value + 16) / 116;
  const double deviation = 0.5 * 0.082 * flipPixelsPerDegree;
  const int radius = int(std::ceil(3 * deviation));
  const std::vector<double> smooth = gaussianKernel(radius, deviation);
  std::vector<double> first, second;
  for (int x = -radius; x <= radius; ++x) {
    first.push_back(-x * smooth[std::size_t(x + radius)]);
    second.push_back((x * x / (deviation * deviation) - 1) * smooth[std::size_t(x + radius)]);
  }
  normaliseSigns(first);
  normaliseSigns(second);
  return {.edges = strengths(achromatic, first, smooth), .points = strengths(achromatic, second, smooth)};
}

}  // namespace

double flip(const Image& reference, const Image& test) {
  checkEqualSizes(reference, test);
  const Planes r = opponentPlanes(reference), t = opponentPlanes(test);
  const std::vector<Rgb> coloursR = resolvedColours(r), coloursT = resolvedColours(t);
  const FeatureStrengths featuresR = features(r[0]), featuresT = features(t[0]);
  double sum = 0;
  for (std::size_t i = 0; i < coloursR.size(); ++i) {
    const double feature = std::max(std::abs(featuresR.edges[i] - featuresT.edges[i]),
                                    std::abs(featuresR.points[i] - featuresT.points[i]));
    const double colour = colourError(colourDistance(coloursR[i], coloursT[i]));
    sum += std::pow(colour, 1 - std::sqrt(feature / std::numbers::sqrt2));
  }
  return sum / double(coloursR.size());
}

namespace {

Plane encodedLuminance(const Image& image) {
  return planeOf(image, [](const Rgb& radiance) { return toSrgb(luminance(displayed(radiance))); });
}

Plane windowMean(const Plane& plane) {
  const std::vector<double> window = gaussianKernel(similarityWindow / 2, 1.5);
  return filtered(plane, window, window);
}

Plane product(const Plane& a, const Plane& b) {
  Plane result = a;
  for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] *= b.values[i];
  return result;
}

}  // namespace

double structuralSimilarity(const Image& reference, const Image& test) {
  checkEqualSizes(reference, test);
  constexpr int margin = similarityWindow / 2;
  if (reference.width < similarityWindow || reference.height < similarityWindow)
    return std::numeric_limits<double>::quiet_NaN();
  const Plane x = encodedLuminance(reference), y = encodedLuminance(test);
  const Plane meanX = windowMean(x), meanY = windowMean(y), squareX = windowMean(product(x, x)),
              squareY = windowMean(product(y, y)), productXy = windowMean(product(x, y));
  constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
  double sum = 0;
  for (int row = margin; row < x.height - margin; ++row)
    for (int column = margin; column < x.width - margin; ++column) {
      const std::size_t i = reference.index(column, row);
      const double mx = meanX.values[i], my = meanY.values[i];
      const double varianceX = squareX.values[i] - mx * mx, varianceY = squareY.values[i] - my * my,
                   covariance = productXy.values[i] - mx * my;
      sum += (2 * mx * my + c1) * (2 * covariance + c2) / ((mx * mx + my * my + c1) * (varianceX + varianceY + c2));
    }
  return sum / (double(x.width - 2 * margin) * double(x.height - 2 * margin));
}

}  // namespace gonio::metrics
