// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/sampling/tabulated_density.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/brdf/normal_square.h"
#include "core/brdf/value_bound.h"
#include "core/math/fast_functions.h"
#include "core/math/parallel.h"
#include "core/math/sampling.h"
#include "core/math/types.h"
#include "core/sampling/narrow_peaks.h"

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
  const double sine = 2 * t * scale;
  const auto [s, c] = fastSineAndCosine(square.y - 0.5);
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

/// @param place 0: the first viewer, 1: the last one.
double viewerAngle(double place) {
  const double root = 1 - place * place * (1 - std::sqrt(lastCosine));
  return std::acos(std::min(1.0, root * root));
}

/// Energies per unit area of the square at its nodes, before the slices are normalised.
struct NodeEnergies {
  SliceStack<float> stack;
  /// Whether the BRDF is 0 at all nodes of a slice; its energies are then those of cosine-weighted directions.
  std::vector<char> isDark = std::vector<char>(TabulatedDensity::viewerCount, 1);
};

NodeEnergies nodeEnergies(const Brdf& brdf) {
  constexpr std::size_t columns = TabulatedDensity::columns, rows = TabulatedDensity::rows,
                        viewers = TabulatedDensity::viewerCount;
  NodeEnergies result{.stack = {columns, rows, std::vector<float>(viewers * rows * columns)}};
  std::vector<DirectionPair> pairs(columns * rows), turned(pairs.size());
  std::vector<double> perSquare(pairs.size());
  std::vector<Rgb> values(pairs.size()), sums(pairs.size());
  const int azimuthCount = brdf.isIsotropic() ? 1 : anisotropicAzimuths;
  for (std::size_t viewer = 0; viewer < viewers; ++viewer) {
    const Direction wo = fromSpherical(viewerAngle(double(viewer) / (viewers - 1)), 0);
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
    float* const slice = &result.stack.values[viewer * pairs.size()];
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double density = perSquare[i] > 0 ? (sums[i].x + sums[i].y + sums[i].z) * perSquare[i] / azimuthCount : 0;
      slice[i] = float(std::clamp(density, 0.0, 1e30));
      if (slice[i] > 0) result.isDark[viewer] = 0;
    }
    // Uniform in the square, densities per solid angle would be up to 1e20, and many samples below the horizon.
    if (result.isDark[viewer]) std::copy(perSquare.begin(), perSquare.end(), slice);
  }
  return result;
}

constexpr std::size_t nodesPerSlice = TabulatedDensity::columns * TabulatedDensity::rows;
constexpr double nodesPerArea = double(TabulatedDensity::columns - 1) * double(TabulatedDensity::rows - 1);

/// The energy of peaks between the nodes of one slice.
class PeaksOfSlice {
 public:
  /// @param nodes the density without these peaks. @param total energy of the slice at its nodes; 0 if it is dark.
  PeaksOfSlice(const Brdf& brdf, const ValueBound& bound, const MarginalWarp& nodes, std::size_t viewer, double total)
      : brdf_(brdf), nodes_(nodes), blend_{1, {std::uint32_t(viewer)}, {1.0}}, total_(total), raised_(nodesPerSlice) {
    // The viewers that are nearer to this slice than to the next ones.
    const double last = double(TabulatedDensity::viewerCount - 1);
    const auto angle = [&](double place) { return viewerAngle(std::clamp(place / last, 0.0, 1.0)); };
    const PeakSearch search{.thetaO = {angle(double(viewer) - 0.5), angle(double(viewer) + 0.5)},
                            .phiO = brdf.isIsotropic() ? Range(0) : Range(0, 2 * pi),
                            .albedo = total / 3,
                            .cells = 2,
                            .steps = 400};
    const std::vector<NarrowPeak> peaks =
        narrowPeaks(bound, brdf.isIsotropic(), search, [this](const DirectionPair& pair) { return density(pair); });
    double most = 0;
    for (const NarrowPeak& peak : peaks) most += peak.most;
    for (const NarrowPeak& peak : peaks) include(peak, peak.most / most);
  }

  double energy() const { return energy_; }
  /// At the nodes, per unit area.
  double at(std::size_t node) const { return raised_[node] * nodesPerArea; }

 private:
  double density(const DirectionPair& pair) const {
    const Direction half = glm::normalize(pair.wi + pair.wo);
    const glm::dvec2 square = toDensitySquare(half, densityAxis(pair.wo));
    const double tabulated =
        nodes_.density(blend_, square) * densitySquarePerSolidAngle(square.x, glm::dot(half, pair.wo));
    return TabulatedDensity::cosineFraction * pair.wi.z / pi + (1 - TabulatedDensity::cosineFraction) * tabulated;
  }

  /// @param part of the points.
  void include(const NarrowPeak& peak, double part) {
    constexpr std::uint32_t points = 1 << 12, fewest = 32;
    const std::uint32_t count = std::max(fewest, std::uint32_t(points * part));
    const std::uint32_t halfSeed = ++seed_, viewerSeed = hashCombine(halfSeed, 1);
    std::vector<DirectionPair> pairs;
    std::vector<double> lights;
    double expected = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      const PeakPair point =
          pairInPeak(peak, brdf_.isIsotropic(), scrambledSobol(i, halfSeed), scrambledSobol(i, viewerSeed));
      if (!(point.weight > 0)) continue;
      pairs.push_back(point.pair);
      lights.push_back(point.weight / count);
      expected += density(point.pair) * lights.back() / point.pair.wi.z;
    }
    std::vector<Rgb> values(pairs.size());
    brdf_.evaluate(pairs, values);
    double energy = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      energy += lights[i] *= std::max(0.0, values[i].x + values[i].y + values[i].z);
    // The bound may be far above the values: only what the nodes do not show is added.
    if (energy < 2 * expected * total_) return;
    energy_ += energy;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Direction half = glm::normalize(pairs[i].wi + pairs[i].wo);
      const GridCell cell =
          gridCell(toDensitySquare(half, densityAxis(pairs[i].wo)), TabulatedDensity::columns, TabulatedDensity::rows);
      double* const low = &raised_[cell.row * TabulatedDensity::columns + cell.column];
      double* const high = low + TabulatedDensity::columns;
      low[0] += (1 - cell.x) * (1 - cell.y) * lights[i];
      low[1] += cell.x * (1 - cell.y) * lights[i];
      high[0] += (1 - cell.x) * cell.y * lights[i];
      high[1] += cell.x * cell.y * lights[i];
    }
  }

  const Brdf& brdf_;
  const MarginalWarp& nodes_;
  SliceBlend blend_;
  double total_, energy_ = 0;
  std::vector<double> raised_;
  std::uint32_t seed_ = 31;
};

/// Adds the energy of peaks between the nodes. Returns whether some reflect a noticeable part of the light.
bool addNarrowPeaks(const Brdf& brdf, NodeEnergies& energies) {
  constexpr double noticeable = 0.01;
  const std::shared_ptr<const ValueBound> bound = brdf.valueBound();
  if (!bound) return false;
  const MarginalWarp nodes(energies.stack, "density");
  std::vector<char> found(TabulatedDensity::viewerCount, 0);
  parallelForBlocks(found.size(), 1, [&](std::size_t viewer, std::size_t) {
    const std::span<float> slice = std::span(energies.stack.values).subspan(viewer * nodesPerSlice, nodesPerSlice);
    double total = 0;
    if (!energies.isDark[viewer])
      for (const float energy : slice) total += double(energy) / nodesPerArea;
    const PeaksOfSlice peaks(brdf, *bound, nodes, viewer, total);
    if (!(peaks.energy() > noticeable * total)) return;
    found[viewer] = 1;
    for (std::size_t i = 0; i < nodesPerSlice; ++i)
      slice[i] = float(std::min(1e30, (energies.isDark[viewer] ? 0.0 : double(slice[i])) + peaks.at(i)));
  });
  return std::ranges::find(found, 1) != found.end();
}

SliceStack<float> densities(const Brdf& brdf, bool& isBlack) {
  NodeEnergies energies = nodeEnergies(brdf);
  const bool hasNarrowPeaks = addNarrowPeaks(brdf, energies);
  isBlack = !hasNarrowPeaks && std::ranges::find(energies.isDark, 0) == energies.isDark.end();
  return std::move(energies.stack);
}

/// Whether samples of a closed form find everything that the tabulated one knows, for each viewer: probes at fixed
/// angles of the viewer miss peaks of others, and narrow peaks.
bool coversAllViewers(const SamplingDensity& closedForm, const MarginalWarp& warp) {
  constexpr double mostMoment = 32, cells = nodesPerArea;
  for (std::size_t viewer = 0; viewer < TabulatedDensity::viewerCount; ++viewer) {
    const Direction wo = fromSpherical(viewerAngle(double(viewer) / (TabulatedDensity::viewerCount - 1)), 0);
    double moment = 0;
    for (std::size_t i = 0; i < nodesPerSlice; ++i) {
      const double density = warp.cellDensity().values[viewer * nodesPerSlice + i] * cells;
      if (!(density > 0)) continue;
      const std::size_t column = i % TabulatedDensity::columns, row = i / TabulatedDensity::columns;
      const glm::dvec2 square(double(column) / (TabulatedDensity::columns - 1),
                              double(row) / (TabulatedDensity::rows - 1));
      const Direction half = fromDensitySquare(square, {1, 0});
      const Direction wi = reflected(wo, half);
      if (!(wi.z > 0)) continue;
      moment +=
          density * density / cells * densitySquarePerSolidAngle(square.x, glm::dot(half, wo)) / closedForm.pdf(wi, wo);
    }
    if (moment > mostMoment) return false;
  }
  return true;
}

}  // namespace

TabulatedDensity::TabulatedDensity(const Brdf& brdf)
    : warp_(densities(brdf, isBlack_), "density"),
      grain_(estimateGrainDensity(brdf, *this, cosineFraction)),
      alongGrain_(grain_.rotated()) {
  if (isBlack_) symmetricDensity_ = SamplingDensity{.specularFraction = 0};
  if (isBlack_) return;
  const std::vector<MomentProbe> probes = momentProbes(brdf);
  const SamplingDensity symmetric = estimateSamplingDensity(brdf);
  if (samplerMoment(probes, symmetric) < samplerMoment(probes, tabulatedMixture(*this)) * cost &&
      coversAllViewers(symmetric, warp_))
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
