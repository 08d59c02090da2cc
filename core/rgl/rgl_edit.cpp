// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rgl/rgl_edit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/mat3x3.hpp>

#include "core/brdf/normal_square.h"
#include "core/math/colour.h"
#include "core/math/parallel.h"
#include "core/rgl/rgb_spectra.h"

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

namespace {

/// Beyond this a spectrum is too dark for its shape to mean something.
constexpr double maxScale = 8;
/// Regularisation relative to the mean square of the colours: if the three parts of a spectrum have similar colours,
/// their factors stay near the ratio of the brightness instead of diverging.
constexpr double damping = 1e-4;

/// The factors of the three parts of a spectrum that give a colour. @param parts a column the colour of each part
Rgb scaleTo(const glm::dmat3& parts, const Rgb& colour) {
  const Rgb own = parts * Rgb(1);
  const double brightness = luminance(own) > 0 ? std::clamp(luminance(colour) / luminance(own), 0.0, maxScale) : 1;
  glm::dmat3 normal = glm::transpose(parts) * parts;
  const double trace = normal[0][0] + normal[1][1] + normal[2][2];
  if (!(trace > 0)) return Rgb(1);
  for (int i = 0; i < 3; ++i) normal[i][i] += damping * trace / 3;
  const Rgb missing = colour - parts * Rgb(brightness);
  const Rgb step = glm::inverse(normal) * (glm::transpose(parts) * missing);
  return glm::clamp(Rgb(brightness) + step, Rgb(0), Rgb(maxScale));
}

}  // namespace

SpectralEdit::SpectralEdit(const RglData& data, const SliceStack<glm::vec3>& edited) : data_(data) {
  assert(data.spectra && edited.values.size() == data.rgb.values.size());
  const std::vector<float>& nanometres = data.spectra->nanometres;
  observer_ = spectrumWeights(std::vector<double>(nanometres.begin(), nanometres.end()));
  for (const float at : nanometres) basis_.push_back(spectralBasisAt(at));
  changes_ = changes(edited);
}

std::vector<SpectralEdit::Change> SpectralEdit::changes(const SliceStack<glm::vec3>& edited) const {
  const std::size_t plane = edited.width * edited.height, slices = edited.values.size() / plane;
  std::vector<Change> result(edited.values.size());
  std::vector<glm::dmat3> parts(plane);
  for (std::size_t slice = 0; slice < slices; ++slice) {
    const std::span before(&data_.rgb.values[slice * plane], plane), after(&edited.values[slice * plane], plane);
    if (std::ranges::equal(before, after)) continue;
    std::ranges::fill(parts, glm::dmat3(0));
    for (std::size_t w = 0; w < basis_.size(); ++w) {
      const float* values = &data_.spectra->values[(slice * basis_.size() + w) * plane];
      const glm::dmat3 seen = glm::outerProduct(observer_[w], basis_[w]);
      for (std::size_t node = 0; node < plane; ++node) parts[node] += double(values[node]) * seen;
    }
    for (std::size_t node = 0; node < plane; ++node) {
      if (before[node] == after[node]) continue;
      Change& change = result[slice * plane + node];
      change.scale = scaleTo(parts[node], Rgb(after[node]));
      change.rest = Rgb(after[node]) - parts[node] * change.scale;
    }
  }
  return result;
}

float SpectralEdit::changed(std::size_t wavelength, float value, const Change& change) const {
  if (change.scale == Rgb(1) && change.rest == Rgb(0)) return value;
  const Rgb& basis = basis_[wavelength];
  const double result = double(value) * glm::dot(basis, change.scale) + glm::dot(basis, change.rest);
  return float(std::max(std::min(double(value), 0.0), result));
}

std::vector<float> SpectralEdit::spectra() const {
  const std::size_t plane = data_.rgb.width * data_.rgb.height;
  std::vector<float> result = data_.spectra->values;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const std::size_t slice = i / (plane * basis_.size());
    result[i] = changed(i / plane % basis_.size(), result[i], changes_[slice * plane + i % plane]);
  }
  return result;
}

SliceStack<float> SpectralEdit::plane(double nanometres) const {
  const std::vector<float>& nodes = data_.spectra->nanometres;
  const auto above = std::ranges::lower_bound(nodes, float(nanometres));
  const auto high = std::size_t(std::min(above, nodes.end() - 1) - nodes.begin());
  const bool between = above != nodes.begin() && above != nodes.end();
  const std::size_t low = between ? high - 1 : high;
  const double fraction = between ? (nanometres - nodes[low]) / (double(nodes[high]) - nodes[low]) : 1;
  SliceStack<float> result{data_.rgb.width, data_.rgb.height, std::vector<float>(data_.rgb.values.size())};
  const std::size_t plane = result.width * result.height;
  for (std::size_t node = 0; node < result.values.size(); ++node) {
    const std::size_t start = node / plane * nodes.size() * plane + node % plane;
    const auto at = [&](std::size_t w) { return changed(w, data_.spectra->values[start + w * plane], changes_[node]); };
    result.values[node] = fraction < 1 ? float(std::lerp(double(at(low)), double(at(high)), fraction)) : at(high);
  }
  return result;
}

std::shared_ptr<const RglBrdf> atWavelength(const RglBrdf& file, const Brdf* edited, double nanometres,
                                            const TaskControl& control) {
  const RglData& data = file.tables()->data;
  EditedRgl colours{data.rgb};
  if (edited) colours = editedColours(*file.withIncident(IncidentDirection::viewer), *edited, control);
  const SliceStack<float> plane = SpectralEdit(data, colours.rgb).plane(nanometres);
  SliceStack<glm::vec3> grey{plane.width, plane.height, {}};
  grey.values.reserve(plane.values.size());
  for (const float value : plane.values) grey.values.emplace_back(value);
  SliceStack<float> luminance = samplingLuminance(grey);
  return file.withColours(std::move(grey), std::move(luminance));
}

}  // namespace gonio::rgl
