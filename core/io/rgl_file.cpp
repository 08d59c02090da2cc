// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/rgl_file.h"

#include <algorithm>
#include <cmath>

#include "core/io/format_mismatch.h"
#include "core/io/tensor_file.h"
#include "core/math/spectrum.h"

namespace gonio::io {

namespace {

using Shape = std::vector<std::uint64_t>;

void requireShape(const TensorFile& file, std::string_view name, const Shape& expected) {
  const Tensor& tensor = file.floatField(name, expected.size());
  if (tensor.shape == expected) return;
  Tensor wanted = tensor;
  wanted.shape = expected;
  throw FormatMismatch("'" + std::string(name) + "' " + tensor.describe(), wanted.describe());
}

/// The sizes of a field's last two dimensions, each at least 2.
glm::u64vec2 gridSize(const TensorFile& file, std::string_view name, std::size_t dimensions) {
  const Tensor& tensor = file.floatField(name, dimensions);
  const std::uint64_t height = tensor.shape[dimensions - 2], width = tensor.shape[dimensions - 1];
  if (height < 2 || width < 2)
    throw FormatMismatch("'" + std::string(name) + "' " + tensor.describe(),
                         "at least 2 values along each of the last two dimensions");
  return {width, height};
}

std::vector<float> increasing(const TensorFile& file, std::string_view name) {
  const std::vector<float> nodes = file.floats(name, 1);
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (!(nodes[i] > nodes[i - 1]))
      throw FormatMismatch(
          "'" + std::string(name) + "' with " + std::to_string(nodes[i]) + " after " + std::to_string(nodes[i - 1]),
          "increasing angles");
  if (nodes.empty()) throw FormatMismatch("'" + std::string(name) + "' without values", "at least one angle");
  return nodes;
}

SliceStack<float> stack(const TensorFile& file, std::string_view name, std::size_t dimensions) {
  const glm::u64vec2 size = gridSize(file, name, dimensions);
  return {size.x, size.y, file.floats(name, dimensions)};
}

/// The fields `rgb` or `spectra`, [phi][theta][channel or wavelength][row][column], with the channels brought together:
/// each is a weighted sum of the planes of a slice.
SliceStack<glm::vec3> colours(const TensorFile& file, std::string_view name, std::span<const Rgb> weights,
                              std::uint64_t& negativeCount) {
  const std::vector<float> values = file.floats(name, 5);
  const glm::u64vec2 size = gridSize(file, name, 5);
  const std::size_t plane = size.x * size.y, slice = plane * weights.size();
  SliceStack<glm::vec3> result{size.x, size.y, {}};
  result.values.reserve(values.size() / weights.size());
  for (std::size_t start = 0; start < values.size(); start += slice)
    for (std::size_t node = 0; node < plane; ++node) {
      Rgb colour(0);
      for (std::size_t w = 0; w < weights.size(); ++w) colour += double(values[start + w * plane + node]) * weights[w];
      result.values.push_back(glm::vec3(colour));
    }
  negativeCount = std::uint64_t(std::ranges::count_if(values, [](float value) { return value < 0; }));
  return result;
}

/// What the planes of `rgb` or `spectra` add to linear sRGB.
std::vector<Rgb> planeWeights(const TensorFile& file, bool spectral) {
  if (!spectral) return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<float> wavelengths = increasing(file, "wavelengths");
  return spectrumWeights(std::vector<double>(wavelengths.begin(), wavelengths.end()));
}

/// The field `luminance`, [phi][theta][row][column], as it is; of the colours where there is none.
SliceStack<float> luminance(const TensorFile& file, const Shape& slices, const SliceStack<glm::vec3>& rgb) {
  if (!file.contains("luminance")) {
    SliceStack<float> result{rgb.width, rgb.height, std::vector<float>(rgb.values.size())};
    std::ranges::transform(rgb.values, result.values.begin(),
                           [](const glm::vec3& value) { return std::max(0.0f, float(gonio::luminance(Rgb(value)))); });
    return result;
  }
  const glm::u64vec2 size = gridSize(file, "luminance", 4);
  requireShape(file, "luminance", {slices[0], slices[1], size.y, size.x});
  return {size.x, size.y, file.floatField("luminance", 4).floats()};
}

/// The field `vndf`, [phi][theta][row][column]; where there is none, the visible normals of the distribution
/// `visible_ndf`, or of `ndf`.
SliceStack<float> vndf(const TensorFile& file, const Shape& slices, const RglData& data) {
  if (!file.contains("vndf")) {
    const bool differs = file.contains("visible_ndf");
    return visibleNormals(differs ? stack(file, "visible_ndf", 2) : data.ndf, data.incident, data.isotropic);
  }
  const glm::u64vec2 size = gridSize(file, "vndf", 4);
  requireShape(file, "vndf", {slices[0], slices[1], size.y, size.x});
  return stack(file, "vndf", 4);
}

int reductionOf(const std::vector<float>& phis) {
  if (phis.size() <= 2) return 1;
  const double range = double(phis.back()) - phis.front();
  const double reduction = std::rint(2 * pi / range);
  if (reduction != 1 && reduction != 2 && reduction != 4)
    throw FormatMismatch("incident azimuths that span " + std::to_string(degrees(range)) + " degrees",
                         "a span of 90, 180 or 360 degrees");
  return int(reduction);
}

}  // namespace

RglFile readRgl(const ByteSource& source) {
  const TensorFile file(source);
  RglFile result;
  result.isSpectral = file.contains("spectra") && !file.contains("rgb");
  const std::string_view colourField = result.isSpectral ? "spectra" : "rgb";
  const std::vector<Rgb> weights = planeWeights(file, result.isSpectral);
  RglData data;
  data.incident = ParameterGrid(increasing(file, "phi_i"), increasing(file, "theta_i"));
  const std::vector<float>& phis = data.incident.phis();
  data.isotropic = phis.size() <= 2;
  data.azimuthReduction = reductionOf(phis);

  const std::uint64_t phiCount = phis.size(), thetaCount = data.incident.slices() / phis.size();
  const glm::u64vec2 colourSize = gridSize(file, colourField, 5);
  requireShape(file, colourField, {phiCount, thetaCount, weights.size(), colourSize.y, colourSize.x});
  const Tensor& jacobian = file.field("jacobian", TensorType::uint8, 1);
  if (jacobian.bytes.size() != 1) throw FormatMismatch("'jacobian' " + jacobian.describe(), "one value");

  data.jacobian = jacobian.bytes[0] != std::byte{0};
  data.ndf = stack(file, "ndf", 2);
  data.sigma = stack(file, "sigma", 2);
  data.vndf = vndf(file, {phiCount, thetaCount}, data);
  data.rgb = colours(file, colourField, weights, result.negativeCount);
  if (result.isSpectral)
    data.spectra =
        std::make_shared<const RglSpectra>(RglSpectra{increasing(file, "wavelengths"), file.floats("spectra", 5)});
  data.luminance = luminance(file, {phiCount, thetaCount}, data.rgb);
  result.description = file.text("description");
  for (const std::uint64_t size : file.floatField(colourField, 5).shape) result.grid.push_back(int(size));
  result.brdf = std::make_shared<const RglBrdf>(std::move(data));
  return result;
}

}  // namespace gonio::io
