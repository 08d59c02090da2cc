// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/tabulated_lobe.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/normal_square.h"
#include "core/coordinates/azimuth_rotation.h"

namespace gonio {

namespace {

/// Over which the values of an anisotropic BRDF are added.
constexpr int anisotropicAzimuths = 8;
/// The square of half vectors, finer still towards the normal: x is (theta 2/pi)^(1/4), which resolves mirrors.
glm::dvec2 toLobeSquare(const glm::dvec2& normalSquare) { return {std::sqrt(normalSquare.x), normalSquare.y}; }
glm::dvec2 toNormalSquare(const glm::dvec2& lobeSquare) { return {lobeSquare.x * lobeSquare.x, lobeSquare.y}; }
/// Area of that square a solid angle of reflected directions, 1/sr.
double lobeSquarePerSolidAngle(const glm::dvec2& lobeSquare, const Direction& sum, const Direction& w) {
  constexpr double smallest = 1e-6;
  return squarePerSolidAngle(toNormalSquare(lobeSquare), sum, w) / (2 * std::max(lobeSquare.x, smallest));
}

constexpr double lastViewer = halfPi * 0.999, spacing = 1.5;

SliceBlend viewersAbout(double theta) {
  const double place =
      (TabulatedLobe::viewerCount - 1) * (1 - std::pow(std::max(0.0, 1 - theta / lastViewer), 1 / spacing));
  const auto low = std::min(std::uint32_t(place), std::uint32_t(TabulatedLobe::viewerCount - 2));
  return {2, {low, low + 1}, {1 - (place - low), place - low}};
}

SliceStack<float> densities(const Brdf& brdf) {
  constexpr std::size_t columns = TabulatedLobe::columns, rows = TabulatedLobe::rows,
                        viewers = TabulatedLobe::viewerCount;
  SliceStack<float> stack{columns, rows, std::vector<float>(viewers * rows * columns)};
  std::vector<DirectionPair> pairs(columns * rows), turned(pairs.size());
  std::vector<double> perSquare(pairs.size());
  std::vector<Rgb> values(pairs.size()), sums(pairs.size());
  const int azimuths = brdf.isIsotropic() ? 1 : anisotropicAzimuths;
  for (std::size_t viewer = 0; viewer < viewers; ++viewer) {
    const Direction wo = fromSpherical(TabulatedLobe::viewerAngle(viewer), 0);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const glm::dvec2 square(double(i % columns) / (columns - 1), double(i / columns) / (rows - 1));
      const Direction half = fromNormalSquare(toNormalSquare(square), 0);
      const Direction wi = reflected(wo, half);
      pairs[i] = {wi, wo};
      const bool seen = wi.z > 0 && square.x > 0;
      perSquare[i] = seen ? wi.z / lobeSquarePerSolidAngle(square, wi + wo, wo) : 0;
    }
    std::fill(sums.begin(), sums.end(), Rgb(0));
    for (int azimuth = 0; azimuth < azimuths; ++azimuth) {
      std::transform(pairs.begin(), pairs.end(), turned.begin(), AzimuthRotation(2 * pi * azimuth / azimuths));
      brdf.evaluate(turned, values);
      for (std::size_t i = 0; i < pairs.size(); ++i) sums[i] += values[i];
    }
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double density = perSquare[i] > 0 ? (sums[i].x + sums[i].y + sums[i].z) * perSquare[i] : 0;
      stack.values[viewer * pairs.size() + i] = float(std::clamp(density, 0.0, 1e30));
    }
  }
  return stack;
}

}  // namespace

TabulatedLobe::TabulatedLobe(const Brdf& brdf) : warp_(densities(brdf), "density", MarginalWarp::EmptySlice::uniform) {}

double TabulatedLobe::viewerAngle(std::size_t viewer) {
  return lastViewer * (1 - std::pow(1 - double(viewer) / (viewerCount - 1), spacing));
}

Direction TabulatedLobe::sample(const Direction& wo, const glm::dvec2& u) const {
  const glm::dvec2 square = toNormalSquare(warp_.sample(viewersAbout(polarAngle(wo)), u).point);
  return reflected(wo, fromNormalSquare(square, azimuth(wo)));
}

double TabulatedLobe::density(const Direction& w, const Direction& wo) const {
  const Direction sum = w + wo;
  if (!isHalfVector(sum)) return 0;
  const glm::dvec2 square = toLobeSquare(gonio::toNormalSquare(sum, azimuth(wo)));
  return warp_.density(viewersAbout(polarAngle(wo)), square) * lobeSquarePerSolidAngle(square, sum, wo);
}

bool areSimilar(const TabulatedLobe& a, const TabulatedLobe& b) {
  const std::vector<float>&first = a.warp().cellDensity().values, &second = b.warp().cellDensity().values;
  double difference = 0;
  for (std::size_t i = 0; i < first.size(); ++i) difference += std::abs(double(first[i]) - second[i]);
  return difference / 2 < 0.1 * double(TabulatedLobe::viewerCount);
}

}  // namespace gonio
