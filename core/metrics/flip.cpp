// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/metrics/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numeric>

#include "core/math/srgb.h"
#include "core/metrics/image_metrics.h"
#include "core/metrics/metric_domain.h"
#include "core/metrics/plane_filter.h"

namespace gonio::metrics {

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

}  // namespace gonio::metrics
