// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/sampling/tabulated_density.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/brdf/normal_square.h"
#include "core/math/fast_functions.h"
#include "core/math/types.h"

namespace gonio {

namespace {

// The unit square of half vectors: x = tan(theta/2)^(1/4), which resolves mirror-like highlights without trigonometric
// functions; y = (phi + pi) / (2 pi), with phi the azimuth relative to the viewer's. The same functions in GLSL:
// shaders/preview/sampling_density.glsl.

/// The horizontal direction of azimuth 0: the viewer's, or the x axis for a viewer at the normal.
glm::dvec2 densityAxis(const Direction& wo) {
  const double length = std::sqrt(wo.x * wo.x + wo.y * wo.y);
  return length > 0 ? glm::dvec2(wo.x, wo.y) / length : glm::dvec2(1, 0);
}

/// @param half unit vector, z >= 0.
glm::dvec2 toDensitySquare(const Direction& half, const glm::dvec2& axis) {
  const double tangent = std::sqrt(half.x * half.x + half.y * half.y) / (1 + half.z);
  const double phi = fastAtan2(axis.x * half.y - axis.y * half.x, axis.x * half.x + axis.y * half.y);
  return {std::sqrt(std::sqrt(tangent)), (phi + pi) / (2 * pi)};
}

Direction fromDensitySquare(const glm::dvec2& square, const glm::dvec2& axis) {
  const double squared = square.x * square.x, t = squared * squared, scale = 1 / (1 + t * t);
  const double phi = 2 * pi * square.y - pi, c = std::cos(phi), s = std::sin(phi), sine = 2 * t * scale;
  return {sine * (axis.x * c - axis.y * s), sine * (axis.y * c + axis.x * s), (1 - t * t) * scale};
}

/// Area of the square per solid angle of reflected directions, 1/sr. @param x of the square. @param cosD cosine of the
/// angle between the half vector and either direction.
double densitySquarePerSolidAngle(double x, double cosD) {
  // The stretch falls below this bound only within about 1e-18 rad of the pole, where nothing is sampled.
  constexpr double minStretch = 1e-30;
  const double x2 = x * x, x4 = x2 * x2, one = 1 + x4 * x4;
  const double stretch = 32 * pi * x4 * x2 * x / (one * one);
  return 1 / (std::max(stretch, minStretch) * 4 * std::max(cosD, 1e-12));
}

/// Over which the values of an anisotropic BRDF are added.
constexpr int anisotropicAzimuths = 8;
constexpr double lastCosine = 1.6e-3;  // of a viewer: 89.9 degrees

/// The viewers that one lies between: they are in steps of sqrt(1 - sqrt(cosine)), which are even angles near the
/// normal and smaller ones toward the horizon, where highlights change fastest.
SliceBlend viewersAbout(double cosine) {
  constexpr auto last = TabulatedDensity::viewerCount - 1;
  const double fraction = (1 - std::sqrt(std::clamp(cosine, lastCosine, 1.0))) / (1 - std::sqrt(lastCosine));
  const double place = double(last) * std::sqrt(fraction);
  const auto low = std::min(std::uint32_t(place), std::uint32_t(last - 1));
  return {2, {low, low + 1}, {1 - (place - low), place - low}};
}

double viewerAngle(std::size_t viewer) {
  const double place = double(viewer) / (TabulatedDensity::viewerCount - 1);
  const double root = 1 - place * place * (1 - std::sqrt(lastCosine));
  return std::acos(std::min(1.0, root * root));
}

SliceStack<float> densities(const Brdf& brdf) {
  constexpr std::size_t columns = TabulatedDensity::columns, rows = TabulatedDensity::rows,
                        viewers = TabulatedDensity::viewerCount;
  SliceStack<float> stack{columns, rows, std::vector<float>(viewers * rows * columns)};
  std::vector<DirectionPair> pairs(columns * rows), turned(pairs.size());
  std::vector<double> perSquare(pairs.size());
  std::vector<Rgb> values(pairs.size()), sums(pairs.size());
  const int azimuthCount = brdf.isIsotropic() ? 1 : anisotropicAzimuths;
  for (std::size_t viewer = 0; viewer < viewers; ++viewer) {
    const Direction wo = fromSpherical(viewerAngle(viewer), 0);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const std::size_t column = i % columns, row = i / columns;
      const glm::dvec2 square(double(column) / (columns - 1), double(row) / (rows - 1));
      const Direction half = fromDensitySquare(square, {1, 0});
      const Direction wi = reflected(wo, half);
      pairs[i] = {wi, wo};
      const bool seen = wi.z > 0 && square.x > 0;
      perSquare[i] = seen ? wi.z / densitySquarePerSolidAngle(square.x, glm::dot(half, wo)) : 0;
    }
    std::fill(sums.begin(), sums.end(), Rgb(0));
    for (int azimuth = 0; azimuth < azimuthCount; ++azimuth) {
      std::transform(pairs.begin(), pairs.end(), turned.begin(), AzimuthRotation(2 * pi * azimuth / azimuthCount));
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

TabulatedDensity::TabulatedDensity(const Brdf& brdf)
    : warp_(densities(brdf), "density", MarginalWarp::EmptySlice::uniform),
      grain_(estimateGrainDensity(brdf, *this, cosineFraction)),
      alongGrain_(grain_.rotated()) {
  const std::vector<MomentProbe> probes = momentProbes(brdf);
  const SamplingDensity symmetric = estimateSamplingDensity(brdf);
  if (samplerMoment(probes, symmetric) < samplerMoment(probes, tabulatedMixture(*this)) * cost)
    symmetricDensity_ = symmetric;
}

Direction TabulatedDensity::sample(const Direction& wo, const glm::dvec2& u) const {
  const Direction wi = reflected(wo, fromDensitySquare(warp_.sample(viewersAbout(wo.z), u).point, densityAxis(wo)));
  return wi.z > 0 ? wi : Direction(0);
}

double TabulatedDensity::density(const Direction& w, const Direction& wo) const {
  if (!(w.z > 0)) return 0;
  const Direction sum = w + wo;
  if (!isHalfVector(sum)) return 0;
  const Direction half = sum / std::sqrt(glm::dot(sum, sum));
  const glm::dvec2 square = toDensitySquare(half, densityAxis(wo));
  return warp_.density(viewersAbout(wo.z), square) * densitySquarePerSolidAngle(square.x, glm::dot(half, wo));
}

bool areSimilar(const TabulatedDensity& a, const TabulatedDensity& b) {
  if (a.symmetricDensity().has_value() != b.symmetricDensity().has_value() || !areSimilar(a.grain(), b.grain()))
    return false;
  if (a.symmetricDensity()) return areSimilar(*a.symmetricDensity(), *b.symmetricDensity());
  const std::vector<float>&first = a.warp().cellDensity().values, &second = b.warp().cellDensity().values;
  double difference = 0;
  for (std::size_t i = 0; i < first.size(); ++i) difference += std::abs(double(first[i]) - second[i]);
  return difference / 2 < 0.1 * double(TabulatedDensity::viewerCount);
}

}  // namespace gonio
