// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rgl/rgl_sampler.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/brdf/normal_square.h"
#include "core/rgl/rgl_edit.h"

namespace gonio::rgl {

namespace {

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
