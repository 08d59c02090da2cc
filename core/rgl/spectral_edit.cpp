// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rgl/spectral_edit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/mat3x3.hpp>

#include "core/math/spectrum.h"
#include "core/rgl/rgb_spectra.h"
#include "core/rgl/rgl_edit.h"

namespace gonio::rgl {

namespace {

/// Beyond this a spectrum is too dark for its shape to mean something.
constexpr double maxScale = 8;
/// Of the mean square of the colours: where the three parts of a spectrum look alike their factors stay near the
/// brightness instead of running apart.
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
