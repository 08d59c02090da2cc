// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rgl/rgl_edit.h"

#include <algorithm>

#include "core/brdf/normal_square.h"
#include "core/math/parallel.h"

namespace gonio::rgl {

namespace {

constexpr SliceBlend onlyEditSlice{1, {0}, {1}};
/// As RglBrdf divides: not by less.
constexpr double minLightCosine = 1e-3;

/// The nodes of one slice: directions, and what a BRDF value is multiplied by to be a value of the field.
struct SliceNodes {
  std::vector<DirectionPair> pairs;
  std::vector<double> scale;  ///< 0 where no light comes from above the horizon
};

SliceNodes nodesOf(const RglBrdf::Tables& tables, std::size_t slice) {
  const RglData& data = tables.data;
  const std::size_t thetas = data.incident.thetas().size();
  const double phi = data.incident.phis()[slice / thetas], theta = data.incident.thetas()[slice % thetas];
  const Direction viewer = fromSpherical(theta, phi);
  const double sigma = interpolate<double>(data.sigma, onlyEditSlice, toNormalSquare(viewer, 0));
  const SliceBlend blend{1, {std::uint32_t(slice)}, {1}};
  SliceNodes nodes;
  for (std::size_t row = 0; row < data.rgb.height; ++row)
    for (std::size_t column = 0; column < data.rgb.width; ++column) {
      const glm::dvec2 at(double(column) / double(data.rgb.width - 1), double(row) / double(data.rgb.height - 1));
      const glm::dvec2 square = tables.visibleNormals.sample(blend, at).point;
      const Direction light = reflected(viewer, fromNormalSquare(square, data.isotropic ? phi : 0));
      const double ndf = data.jacobian ? interpolate<double>(data.ndf, onlyEditSlice, square) : 4 * sigma;
      const bool seen = light.z > horizonTolerance && ndf > 0 && viewer.z > horizonTolerance;
      nodes.pairs.push_back({seen ? glm::normalize(light) : viewer, viewer});
      nodes.scale.push_back(seen ? std::max(light.z, minLightCosine) * 4 * sigma / ndf : 0);
    }
  return nodes;
}

void editSlice(const RglBrdf& file, const Brdf& edited, std::size_t slice, std::span<glm::vec3> rgb) {
  const SliceNodes nodes = nodesOf(*file.tables(), slice);
  std::vector<Rgb> before(nodes.pairs.size()), after(nodes.pairs.size());
  file.evaluate(nodes.pairs, before);
  edited.evaluate(nodes.pairs, after);
  const std::size_t width = file.tables()->data.rgb.width;
  Rgb difference(0);
  for (std::size_t node = 0; node < rgb.size(); ++node) {
    if (node % width == 0) difference = Rgb(0);
    if (nodes.scale[node] > 0) difference = (after[node] - before[node]) * nodes.scale[node];
    for (int channel = 0; channel < 3; ++channel)
      if (difference[channel] != 0) rgb[node][channel] = float(double(rgb[node][channel]) + difference[channel]);
  }
}

}  // namespace

EditedRgl editedColours(const RglBrdf& file, const Brdf& edited, const TaskControl& control) {
  const RglData& data = file.tables()->data;
  EditedRgl result{data.rgb};
  const std::size_t plane = data.rgb.width * data.rgb.height;
  parallelForBlocks(
      data.incident.slices(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t slice = begin; slice < end; ++slice)
          editSlice(file, edited, slice, std::span(&result.rgb.values[slice * plane], plane));
      },
      control);
  result.changed = result.rgb.values != data.rgb.values;
  return result;
}

SliceStack<float> samplingLuminance(const SliceStack<glm::vec3>& rgb) {
  constexpr float minFraction = 1e-3f;
  SliceStack<float> result{rgb.width, rgb.height, std::vector<float>(rgb.values.size())};
  std::ranges::transform(rgb.values, result.values.begin(),
                         [](const glm::vec3& value) { return float(luminance(Rgb(value))); });
  const std::size_t plane = rgb.width * rgb.height;
  for (std::size_t start = 0; start < result.values.size(); start += plane) {
    const std::span slice(&result.values[start], plane);
    const float largest = std::ranges::max(slice);
    for (float& value : slice) value = largest > 0 ? std::max(value, minFraction * largest) : 1;
  }
  return result;
}

}  // namespace gonio::rgl
