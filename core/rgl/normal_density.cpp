// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rgl/normal_density.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/normal_square.h"
#include "core/math/quadrature.h"

namespace gonio::rgl {

namespace {

/// Directions of the hemisphere: rings of equal polar angle at the columns of the square, `azimuths` on each.
class Rings {
 public:
  /// @param distinct how many azimuths of a ring have a density of their own; 1: they are all alike.
  Rings(std::size_t columns, std::size_t distinct) : columns_(columns), distinct_(distinct) {
    constexpr std::size_t isotropicAzimuths = 64;
    azimuths_ = distinct == 1 ? isotropicAzimuths : distinct;
    for (std::size_t column = 0; column < columns; ++column)
      for (std::size_t row = 0; row < azimuths_; ++row)
        directions_.push_back(fromNormalSquare({x(column), double(row) / double(azimuths_)}, 0));
  }

  /// The density nodes: distinct() of each ring, ring by ring.
  std::size_t size() const { return columns_ * distinct_; }
  const Direction& direction(std::size_t node) const {
    return directions_[node / distinct_ * azimuths_ + node % distinct_];
  }
  /// Solid angle that a direction of a ring stands for: sin theta dtheta dphi with theta = x^2 pi/2.
  double solidAngle(std::size_t ring) const {
    const double dx = (ring == 0 || ring + 1 == columns_ ? 0.5 : 1) / double(columns_ - 1);
    return std::sin(x(ring) * x(ring) * halfPi) * pi * x(ring) * dx * 2 * pi / double(azimuths_);
  }

  /// Calls visit(node, direction) for all directions, those that share a node too.
  void forEachDirection(const auto& visit) const {
    for (std::size_t i = 0; i < directions_.size(); ++i)
      visit(i / azimuths_ * distinct_ + i % azimuths_ % distinct_, directions_[i]);
  }

  /// Integral of density max(0, w . m) dm.
  double project(const std::vector<double>& density, const Direction& w) const {
    double sum = 0;
    for (std::size_t ring = 0; ring < columns_; ++ring) {
      double part = 0;
      for (std::size_t row = 0; row < azimuths_; ++row)
        part += density[ring * distinct_ + row % distinct_] *
                std::max(0.0, glm::dot(w, directions_[ring * azimuths_ + row]));
      sum += part * solidAngle(ring);
    }
    return sum;
  }

 private:
  double x(std::size_t column) const { return double(column) / double(columns_ - 1); }

  std::size_t columns_, distinct_, azimuths_ = 0;
  std::vector<Direction> directions_;
};

/// To the integral 1 of density cos theta; uniform where there is nothing to scale.
void normalise(const Rings& rings, std::vector<double>& density) {
  const double total = rings.project(density, {0, 0, 1});
  if (total > 0)
    for (double& value : density) value /= total;
  else
    std::ranges::fill(density, 1 / pi);
}

/// Y(f(w, w)) cos theta.
std::vector<double> retroReflection(const Brdf& material, const Rings& rings) {
  std::vector<DirectionPair> pairs;
  for (std::size_t node = 0; node < rings.size(); ++node)
    pairs.push_back({rings.direction(node), rings.direction(node)});
  std::vector<Rgb> values(pairs.size());
  material.evaluate(pairs, values);
  std::vector<double> result;
  for (std::size_t node = 0; node < values.size(); ++node)
    result.push_back(std::max(0.0, luminance(values[node]) * pairs[node].wi.z));
  return result;
}

/// Nodes of the rings as the rows and columns of a field; the last row is the first again.
template <typename Value>
SliceStack<float> asField(const Rings& rings, const DensitySize& size, const Value& value) {
  const std::size_t distinct = rings.size() / size.columns;
  SliceStack<float> field{size.columns, size.rows, std::vector<float>(size.columns * size.rows)};
  for (std::size_t node = 0; node < rings.size(); ++node) {
    const auto at = float(value(node));
    for (std::size_t row = node % distinct; row < size.rows; row += distinct)
      field.values[row * size.columns + node / distinct] = at;
  }
  return field;
}

/// Of each density node the BRDF's luminance at the pair that it mirrors for a viewer: the mean over the azimuths that
/// share the node, of those where both directions are above the surface; -1 where none is.
std::vector<double> mirrored(const Brdf& material, const Rings& rings, const Direction& viewer) {
  std::vector<DirectionPair> pairs;
  std::vector<std::size_t> nodes;
  rings.forEachDirection([&](std::size_t node, const Direction& normal) {
    const Direction light = reflected(viewer, normal);
    if (!(light.z > horizonTolerance)) return;
    pairs.push_back({glm::normalize(light), viewer});
    nodes.push_back(node);
  });
  std::vector<Rgb> values(pairs.size());
  material.evaluate(pairs, values);
  std::vector<double> sums(rings.size()), counts(rings.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    sums[nodes[i]] += std::max(0.0, luminance(values[i]));
    ++counts[nodes[i]];
  }
  for (std::size_t node = 0; node < sums.size(); ++node) sums[node] = counts[node] > 0 ? sums[node] / counts[node] : -1;
  return sums;
}

/// What rises above the rest of what a viewer sees mirrored, normalised; how much of a highlight it is, from 0 for less
/// than twice the rest to 1.
double toHighlight(const Rings& rings, std::vector<double>& values) {
  constexpr double minMass = 1e-3, restCosine = 0.75;
  const auto isNear = [&](std::size_t node) { return rings.direction(node).z > restCosine && values[node] >= 0; };
  double rest = values.front(), largest = 0;
  for (std::size_t node = 0; node < rings.size(); ++node) {
    if (!isNear(node)) continue;
    rest = std::min(rest, values[node]);
    largest = std::max(largest, values[node]);
  }
  for (std::size_t node = 0; node < rings.size(); ++node) {
    double& value = values[node];
    value = isNear(node) && value > rest ? (value - rest) * (value - rest) / value : 0;  // without a kink
  }
  if (!(largest > 2 * rest) || rings.project(values, {0, 0, 1}) < minMass * rest) return 0;
  normalise(rings, values);
  return 1 - 2 * rest / largest;
}

/// Half of the density goes to the highlights that viewers at several angles see. Retro-reflection does not show how
/// wide they are: coats are seen at a slant alone, and many highlights widen there. A highlight over a bright body
/// would have few nodes beside the many normals that turn to the viewer.
void emphasiseHighlights(const Brdf& material, const Rings& rings, std::vector<double>& density) {
  constexpr double highlightShare = 0.5, maxSquaredSine = 0.95;
  constexpr int polarViewers = 6;
  const std::size_t azimuths = material.isIsotropic() ? 1 : 5;  // odd: a grain looks the same from both sides
  const double share = highlightShare / double(polarViewers * azimuths);
  std::vector<double> highlights(rings.size());
  double rest = 1;
  for (const double squaredSine : gaussLegendre(polarViewers, 0, maxSquaredSine).nodes)
    for (std::size_t i = 0; i < azimuths; ++i) {
      const double phi = 2 * pi * double(i) / double(azimuths);
      std::vector<double> seen = mirrored(material, rings, fromSpherical(std::asin(std::sqrt(squaredSine)), phi));
      const double weight = share * toHighlight(rings, seen);
      if (weight == 0) continue;
      for (std::size_t node = 0; node < seen.size(); ++node) highlights[node] += weight * seen[node];
      rest -= weight;
    }
  for (std::size_t node = 0; node < rings.size(); ++node) density[node] = rest * density[node] + highlights[node];
}

}  // namespace

NormalDensity normalDensity(const Brdf& material, const DensitySize& size, double floor) {
  constexpr int iterations = 4;
  const Rings rings(size.columns, size.rows - 1);
  const std::vector<double> retro = retroReflection(material, rings);
  std::vector<double> density(rings.size(), 1.0);
  for (int i = 0; i < iterations; ++i) {
    std::vector<double> next(rings.size());
    for (std::size_t node = 0; node < next.size(); ++node)
      next[node] = retro[node] > 0 ? retro[node] * rings.project(density, rings.direction(node)) : 0;
    density = std::move(next);
    normalise(rings, density);
  }
  emphasiseHighlights(material, rings, density);
  for (double& value : density) value = (1 - floor) * value + floor / pi;
  normalise(rings, density);
  const auto areaOf = [&](std::size_t node) { return rings.project(density, rings.direction(node)); };
  return {asField(rings, size, [&](std::size_t node) { return density[node]; }), asField(rings, size, areaOf)};
}

SliceStack<float> visibleNormalSlices(const SliceStack<float>& ndf, std::span<const float> phis, double theta,
                                      std::size_t rows, bool isotropic) {
  constexpr SliceBlend onlySlice{1, {0}, {1}};
  SliceStack<float> result{ndf.width, rows, {}};
  result.values.reserve(phis.size() * rows * ndf.width);
  for (const float phi : phis) {
    const Direction w = fromSpherical(theta, phi);
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t column = 0; column < ndf.width; ++column) {
        const glm::dvec2 square(double(column) / double(ndf.width - 1), double(row) / double(rows - 1));
        const Direction normal = fromNormalSquare(square, isotropic ? phi : 0);
        const double visible = interpolate<double>(ndf, onlySlice, square) * std::max(0.0, glm::dot(w, normal));
        result.values.push_back(float(visible * 2 * pi * pi * square.x * std::hypot(normal.x, normal.y)));
      }
  }
  return result;
}

}  // namespace gonio::rgl
