// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/brdf/tabulated_lobe.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/lobe_square.h"
#include "core/brdf/moment_probes.h"
#include "core/brdf/normal_square.h"
#include "core/coordinates/azimuth_rotation.h"

namespace gonio {

namespace {

/// Over which the values of an anisotropic BRDF are added.
constexpr int anisotropicAzimuths = 8;
constexpr double lastCosine = 1.6e-3;  // of a viewer: 89.9 degrees

/// The viewers that one lies between: they are in steps of sqrt(1 - sqrt(cosine)), which are even angles near the
/// normal and smaller ones toward the horizon, where lobes change fastest.
SliceBlend viewersAbout(double cosine) {
  constexpr auto last = TabulatedLobe::viewerCount - 1;
  const double fraction = (1 - std::sqrt(std::clamp(cosine, lastCosine, 1.0))) / (1 - std::sqrt(lastCosine));
  const double place = double(last) * std::sqrt(fraction);
  const auto low = std::min(std::uint32_t(place), std::uint32_t(last - 1));
  return {2, {low, low + 1}, {1 - (place - low), place - low}};
}

double viewerAngle(std::size_t viewer) {
  const double place = double(viewer) / (TabulatedLobe::viewerCount - 1);
  const double root = 1 - place * place * (1 - std::sqrt(lastCosine));
  return std::acos(std::min(1.0, root * root));
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
    const Direction wo = fromSpherical(viewerAngle(viewer), 0);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const std::size_t column = i % columns, row = i / columns;
      const glm::dvec2 square(double(column) / (columns - 1), double(row) / (rows - 1));
      const Direction half = fromLobeSquare(square, {1, 0});
      const Direction wi = reflected(wo, half);
      pairs[i] = {wi, wo};
      const bool seen = wi.z > 0 && square.x > 0;
      perSquare[i] = seen ? wi.z / lobeSquarePerSolidAngle(square.x, glm::dot(half, wo)) : 0;
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

TabulatedLobe::TabulatedLobe(const Brdf& brdf)
    : warp_(densities(brdf), "density", MarginalWarp::EmptySlice::uniform),
      grain_(estimateGrainLobe(brdf, *this, cosineFraction)),
      alongGrain_(grain_.lobe()) {
  const std::vector<MomentProbe> probes = momentProbes(brdf);
  const SamplingLobe symmetric = estimateSamplingLobe(brdf);
  if (samplerMoment(probes, symmetric) < samplerMoment(probes, tabulatedMixture(*this)) * cost)
    symmetricLobe_ = symmetric;
}

Direction TabulatedLobe::sample(const Direction& wo, const glm::dvec2& u) const {
  const Direction wi = reflected(wo, fromLobeSquare(warp_.sample(viewersAbout(wo.z), u).point, lobeAxis(wo)));
  return wi.z > 0 ? wi : Direction(0);
}

double TabulatedLobe::density(const Direction& w, const Direction& wo) const {
  if (!(w.z > 0)) return 0;
  const Direction sum = w + wo;
  if (!isHalfVector(sum)) return 0;
  const Direction half = sum / std::sqrt(glm::dot(sum, sum));
  const glm::dvec2 square = toLobeSquare(half, lobeAxis(wo));
  return warp_.density(viewersAbout(wo.z), square) * lobeSquarePerSolidAngle(square.x, glm::dot(half, wo));
}

bool areSimilar(const TabulatedLobe& a, const TabulatedLobe& b) {
  if (a.symmetricLobe().has_value() != b.symmetricLobe().has_value() || !areSimilar(a.grain(), b.grain())) return false;
  if (a.symmetricLobe()) return areSimilar(*a.symmetricLobe(), *b.symmetricLobe());
  const std::vector<float>&first = a.warp().cellDensity().values, &second = b.warp().cellDensity().values;
  double difference = 0;
  for (std::size_t i = 0; i < first.size(); ++i) difference += std::abs(double(first[i]) - second[i]);
  return difference / 2 < 0.1 * double(TabulatedLobe::viewerCount);
}

}  // namespace gonio
