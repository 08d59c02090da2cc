// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rgl/rgl_sampler.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/brdf/brdf.h"
#include "core/brdf/normal_square.h"
#include "core/math/marginal_warp.h"
#include "core/math/quadrature.h"
#include "core/rgl/rgl_edit.h"

namespace gonio::rgl {

namespace {

/// Number of nodes of a distribution. The polar angle has more nodes than the measurement of a highlight needs.
struct DensitySize {
  std::size_t columns = 128;
  std::size_t rows = 2;  ///< azimuths, including both ends of the circle; 2 for isotropic materials
};

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

/// Scales the density so that density cos theta integrates to 1; a density of 0 becomes uniform.
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

/// The luminance of the BRDF, for each density node, at the pair that it mirrors for a viewer: the mean over those of
/// the node's azimuths where both directions are above the surface; -1 if there is none.
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

/// Replaces the mirrored values of a viewer by their normalised excess over the minimum. Returns how pronounced the
/// highlight is, from 0 (the peak is less than twice the minimum) to 1.
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
  constexpr double highlightFraction = 0.5, maxSquaredSine = 0.95;
  constexpr int polarViewers = 6;
  const std::size_t azimuths = material.isIsotropic() ? 1 : 5;  // odd: a grain looks the same from both sides
  const double fraction = highlightFraction / double(polarViewers * azimuths);
  std::vector<double> highlights(rings.size());
  double rest = 1;
  for (const double squaredSine : gaussLegendre(polarViewers, 0, maxSquaredSine).nodes)
    for (std::size_t i = 0; i < azimuths; ++i) {
      const double phi = 2 * pi * double(i) / double(azimuths);
      std::vector<double> seen = mirrored(material, rings, fromSpherical(std::asin(std::sqrt(squaredSine)), phi));
      const double weight = fraction * toHighlight(rings, seen);
      if (weight == 0) continue;
      for (std::size_t node = 0; node < seen.size(); ++node) highlights[node] += weight * seen[node];
      rest -= weight;
    }
  for (std::size_t node = 0; node < rings.size(); ++node) density[node] = rest * density[node] + highlights[node];
}

/// Estimates a distribution from the material's retro-reflection, as if it were single reflection by mirror facets: the
/// dominant eigenvector of Dupuy et al. 2015, "Extracting Microfacet-based BRDF Parameters from Arbitrary Materials
/// with Power Iterations", after four iterations, normalised so that D cos theta integrates to 1. Up to half of D is
/// then replaced by the highlights that viewers at six polar angles see. A highlight is the excess of the values over
/// their minimum, for half vectors within 41 degrees of the normal; subtracting the minimum removes the diffuse term.
/// Finally the uniform distribution 1/pi is mixed in with the fraction `floor`. A material without retro-reflection
/// starts from the uniform distribution. The result only serves as a parameterisation, for which any positive D is
/// correct. (columns rows)^2 steps: a few ms isotropic, about 0.1 s anisotropic.
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

/// The field `vndf` for one polar angle `theta` of the incident direction (rad) and all azimuths `phis`, one slice
/// each: D(m) max(0, w . m) times the solid angle of normals per area of the square, with `rows` rows and the columns
/// of the ndf.
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

constexpr SliceBlend onlySlice{1, {0}, {1}};

/// The pairs of directions at the nodes of one azimuth, and their scales.
void appendNodes(const RglLayout& layout, const MarginalWarp& normals, std::size_t azimuthIndex, std::size_t size,
                 RglSlice& slice) {
  const double phi = layout.phis[azimuthIndex], last = double(size - 1);
  const Direction viewer = fromSpherical(slice.theta, phi);
  const double sigma = interpolate<double>(layout.density.sigma, onlySlice, toNormalSquare(viewer, 0));
  const SliceBlend blend{1, {std::uint32_t(azimuthIndex)}, {1}};
  for (std::size_t row = 0; row < size; ++row)
    for (std::size_t column = 0; column < size; ++column) {
      const glm::dvec2 square = normals.sample(blend, {double(column) / last, double(row) / last}).point;
      const Direction light = reflected(viewer, fromNormalSquare(square, layout.isotropic ? phi : 0));
      const double ndf = interpolate<double>(layout.density.ndf, onlySlice, square);
      const bool seen = light.z > horizonTolerance && ndf > 0;
      slice.pairs.push_back({seen ? glm::normalize(light) : viewer, viewer});
      slice.scale.push_back(seen ? light.z * 4 * sigma / ndf : 0);
    }
}

}  // namespace

RglLayout rglLayout(const Brdf& material, std::size_t azimuths, double floor) {
  RglLayout layout;
  layout.isotropic = material.isIsotropic();
  if (layout.isotropic) {
    layout.density = normalDensity(material, {}, floor);
    return layout;
  }
  layout.density = normalDensity(material, {.columns = 64, .rows = 65}, floor);
  layout.phis.clear();
  for (std::size_t i = 0; i <= azimuths; ++i) layout.phis.push_back(float(2 * pi * double(i) / double(azimuths) - pi));
  return layout;
}

RglSlice sampleSlice(const Brdf& material, const RglLayout& layout, double theta, std::size_t size) {
  RglSlice slice;
  slice.theta = float(theta);
  slice.vndf = visibleNormalSlices(layout.density.ndf, layout.phis, slice.theta, layout.vndfRows, layout.isotropic);
  const MarginalWarp normals(slice.vndf, "vndf");
  for (std::size_t i = 0; i < layout.phis.size(); ++i) appendNodes(layout, normals, i, size, slice);
  std::vector<Rgb> values(slice.pairs.size());
  material.evaluate(slice.pairs, values);
  slice.rgb = {size, size, {}};
  slice.rgb.values.reserve(values.size());
  for (std::size_t node = 0; node < values.size(); ++node)
    slice.rgb.values.push_back(glm::vec3(slice.scale[node] > 0 ? values[node] * slice.scale[node] : Rgb(0)));
  return slice;
}

RglData assemble(const RglLayout& layout, std::span<const RglSlice* const> slices) {
  const RglSlice& first = *slices.front();
  RglData data;
  data.isotropic = layout.isotropic;
  data.ndf = layout.density.ndf;
  data.sigma = layout.density.sigma;
  data.vndf = {first.vndf.width, first.vndf.height, {}};
  data.rgb = {first.rgb.width, first.rgb.height, {}};
  std::vector<float> thetas;
  for (const RglSlice* slice : slices) thetas.push_back(slice->theta);
  for (std::size_t azimuth = 0; azimuth < layout.phis.size(); ++azimuth)
    for (const RglSlice* slice : slices) {
      const auto append = [azimuth](const auto& from, auto& to) {
        const std::size_t plane = from.width * from.height;
        const auto begin = from.values.begin() + std::ptrdiff_t(azimuth * plane);
        to.values.insert(to.values.end(), begin, begin + std::ptrdiff_t(plane));
      };
      append(slice->vndf, data.vndf);
      append(slice->rgb, data.rgb);
    }
  data.incident = ParameterGrid(layout.phis, std::move(thetas));
  data.luminance = samplingLuminance(data.rgb);
  return data;
}

namespace {

constexpr std::size_t probeSize = 16;  // a power of two
/// A jump between two angles, which tables have, is not worth more of them.
constexpr double minWidth = radians(0.5);
/// The rest of the sphere's rim is 1/3000 of its disk.
constexpr double firstAngles[] = {0, radians(89), radians(75), radians(45)};

using SharedSlice = std::shared_ptr<const RglSlice>;

struct Interval {
  SharedSlice low, middle, high;
  double error = 0;
};

/// Sum over the blocks of all sizes from one node to the whole slice of the squared mean error in a block, times its
/// fraction of the slice: lights in a picture are of all sizes.
double errorOfAllSizes(std::span<const Rgb> differences) {
  constexpr std::size_t plane = probeSize * probeSize;
  double sum = 0;
  for (std::size_t block = 1; block <= probeSize; block *= 2)
    for (std::size_t first = 0; first < differences.size(); first += plane)
      for (std::size_t y = 0; y < probeSize; y += block)
        for (std::size_t x = 0; x < probeSize; x += block) {
          Rgb total(0);
          for (std::size_t row = y; row < y + block; ++row)
            for (std::size_t column = x; column < x + block; ++column)
              total += differences[first + row * probeSize + column];
          sum += glm::dot(total, total) / double(block * block);
        }
  return sum;
}

/// Error of the interpolated file at the slice between, as light in the picture of a sphere.
double interpolationError(const RglLayout& layout, const Interval& interval) {
  const double width = double(interval.high->theta) - double(interval.low->theta);
  if (width < minWidth) return 0;
  const RglSlice* const ends[] = {interval.low.get(), interval.high.get()};
  const RglBrdf file(assemble(layout, ends));
  const RglSlice& truth = *interval.middle;
  std::vector<Rgb> values(truth.pairs.size());
  file.evaluate(truth.pairs, values);
  for (std::size_t node = 0; node < values.size(); ++node)
    values[node] = truth.scale[node] > 0 ? values[node] * truth.scale[node] - Rgb(truth.rgb.values[node]) : Rgb(0);
  const double theta = truth.theta;
  return errorOfAllSizes(values) * std::sin(theta) * std::cos(theta) * width;
}

class Placement {
 public:
  Placement(const Brdf& material, const RglLayout& layout) : material_(material), layout_(layout) {
    std::vector<double> ascending(std::begin(firstAngles), std::end(firstAngles));
    std::ranges::sort(ascending);
    for (std::size_t i = 0; i + 1 < ascending.size(); ++i) add(sample(ascending[i]), sample(ascending[i + 1]));
  }

  /// The angle of the worst interval, which becomes two.
  double split() {
    const auto worst = std::ranges::max_element(intervals_, {}, &Interval::error);
    const Interval interval = *worst;
    intervals_.erase(worst);
    add(interval.low, interval.middle);
    add(interval.middle, interval.high);
    return interval.middle->theta;
  }

 private:
  SharedSlice sample(double theta) const {
    return std::make_shared<const RglSlice>(sampleSlice(material_, layout_, theta, probeSize));
  }
  void add(const SharedSlice& low, const SharedSlice& high) {
    Interval interval{low, sample(0.5 * (double(low->theta) + double(high->theta))), high};
    interval.error = interpolationError(layout_, interval);
    intervals_.push_back(std::move(interval));
  }

  const Brdf& material_;
  const RglLayout& layout_;
  std::vector<Interval> intervals_;
};

}  // namespace

std::vector<double> placeAngles(const Brdf& material, const RglLayout& layout, std::size_t count,
                                const TaskControl& control) {
  std::vector<double> angles(std::begin(firstAngles), std::end(firstAngles));
  Placement placement(material, layout);
  while (angles.size() < count) {
    control.throwIfStopped();
    angles.push_back(placement.split());
    control.report(double(angles.size()) / double(count));
  }
  return angles;
}

}  // namespace gonio::rgl
