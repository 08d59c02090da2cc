// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/rgl_sampler.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/normal_square.h"
#include "core/brdf/rgl_luminance.h"

namespace gonio::exports {

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

/// The mean of what lies left and right of the plane of incidence, in each of the n x n planes.
void makeSymmetric(SliceStack<glm::vec3>& rgb) {
  const std::size_t plane = rgb.width * rgb.height;
  for (std::size_t start = 0; start < rgb.values.size(); start += plane)
    for (std::size_t row = 0; row < rgb.height / 2; ++row)
      for (std::size_t column = 0; column < rgb.width; ++column) {
        glm::vec3& left = rgb.values[start + row * rgb.width + column];
        glm::vec3& right = rgb.values[start + (rgb.height - 1 - row) * rgb.width + column];
        left = right = 0.5f * (left + right);
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
  for (std::size_t node = 0; node < values.size(); ++node) {
    const Rgb value = slice.scale[node] > 0 ? values[node] * slice.scale[node] : Rgb(0);
    for (int channel = 0; channel < 3; ++channel) slice.clipped += value[channel] < 0;
    slice.rgb.values.push_back(glm::vec3(glm::max(value, Rgb(0))));
  }
  if (layout.isotropic && layout.mirrorSymmetric) makeSymmetric(slice.rgb);
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

}  // namespace gonio::exports
