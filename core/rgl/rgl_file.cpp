// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rgl/rgl_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/io/byte_source.h"
#include "core/math/colour.h"
#include "core/rgl/rgb_spectra.h"
#include "core/rgl/rgl_edit.h"

namespace gonio::rgl {

namespace {

using Shape = std::vector<std::uint64_t>;

void requireShape(const io::TensorFile& file, std::string_view name, const Shape& expected) {
  const io::TensorView& tensor = file.floatField(name, expected.size());
  if (tensor.shape == expected) return;
  io::TensorView wanted = tensor;
  wanted.shape = expected;
  throw io::FormatMismatch("'" + std::string(name) + "' " + tensor.describe(), wanted.describe());
}

/// The sizes of a field's last two dimensions, each at least 2.
glm::u64vec2 gridSize(const io::TensorFile& file, std::string_view name, std::size_t dimensions) {
  const io::TensorView& tensor = file.floatField(name, dimensions);
  const std::uint64_t height = tensor.shape[dimensions - 2], width = tensor.shape[dimensions - 1];
  if (height < 2 || width < 2)
    throw io::FormatMismatch("'" + std::string(name) + "' " + tensor.describe(),
                             "at least 2 values along each of the last two dimensions");
  return {width, height};
}

std::vector<float> increasing(const io::TensorFile& file, std::string_view name) {
  const std::vector<float> nodes = file.floats(name, 1);
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (!(nodes[i] > nodes[i - 1]))
      throw io::FormatMismatch(
          "'" + std::string(name) + "' with " + std::to_string(nodes[i]) + " after " + std::to_string(nodes[i - 1]),
          "increasing angles");
  if (nodes.empty()) throw io::FormatMismatch("'" + std::string(name) + "' without values", "at least one angle");
  return nodes;
}

SliceStack<float> stackOf(const io::TensorFile& file, std::string_view name, std::size_t dimensions) {
  const glm::u64vec2 size = gridSize(file, name, dimensions);
  return {size.x, size.y, file.floats(name, dimensions)};
}

/// The fields `rgb` or `spectra`, [phi][theta][channel or wavelength][row][column], with the channels brought together:
/// each is a weighted sum of the planes of a slice.
SliceStack<glm::vec3> readColours(const io::TensorFile& file, std::string_view name, std::span<const Rgb> weights,
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

/// The weights of the planes of `rgb` or `spectra` in linear sRGB.
std::vector<Rgb> planeWeights(const io::TensorFile& file, bool spectral) {
  if (!spectral) return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<float> wavelengths = increasing(file, "wavelengths");
  return spectrumWeights(std::vector<double>(wavelengths.begin(), wavelengths.end()));
}

/// The field `luminance`, [phi][theta][row][column], as it is; of the colours where there is none.
SliceStack<float> readLuminance(const io::TensorFile& file, const Shape& slices, const SliceStack<glm::vec3>& rgb) {
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
SliceStack<float> readVndf(const io::TensorFile& file, const Shape& slices, const RglData& data) {
  if (!file.contains("vndf")) {
    const bool differs = file.contains("visible_ndf");
    return visibleNormals(differs ? stackOf(file, "visible_ndf", 2) : data.ndf, data.incident, data.isotropic);
  }
  const glm::u64vec2 size = gridSize(file, "vndf", 4);
  requireShape(file, "vndf", {slices[0], slices[1], size.y, size.x});
  return stackOf(file, "vndf", 4);
}

int reductionOf(const std::vector<float>& phis) {
  if (phis.size() <= 2) return 1;
  const double range = double(phis.back()) - phis.front();
  const double reduction = std::rint(2 * pi / range);
  if (reduction != 1 && reduction != 2 && reduction != 4)
    throw io::FormatMismatch("incident azimuths that span " + std::to_string(degrees(range)) + " degrees",
                             "a span of 90, 180 or 360 degrees");
  return int(reduction);
}

}  // namespace

RglFile readRgl(const io::ByteSource& source) {
  const io::TensorFile file(source);
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
  const io::TensorView& jacobian = file.field("jacobian", io::TensorType::uint8, 1);
  if (jacobian.bytes.size() != 1) throw io::FormatMismatch("'jacobian' " + jacobian.describe(), "one value");

  data.jacobian = jacobian.bytes[0] != std::byte{0};
  data.ndf = stackOf(file, "ndf", 2);
  data.sigma = stackOf(file, "sigma", 2);
  data.vndf = readVndf(file, {phiCount, thetaCount}, data);
  data.rgb = readColours(file, colourField, weights, result.negativeCount);
  if (result.isSpectral)
    data.spectra =
        std::make_shared<const RglSpectra>(RglSpectra{increasing(file, "wavelengths"), file.floats("spectra", 5)});
  data.luminance = readLuminance(file, {phiCount, thetaCount}, data.rgb);
  result.description = file.text("description");
  for (const std::uint64_t size : file.floatField(colourField, 5).shape) result.grid.push_back(int(size));
  result.brdf = std::make_shared<const RglBrdf>(std::move(data));
  return result;
}

namespace {

using io::TensorField;

TensorField field(const std::string& name, const SliceStack<float>& stack, std::vector<std::uint64_t> slices) {
  slices.insert(slices.end(), {stack.height, stack.width});
  return TensorField::floats(name, std::move(slices), stack.values);
}

/// The field `rgb`, [phi][theta][channel][row][column].
std::vector<float> colourPlanes(const SliceStack<glm::vec3>& rgb) {
  const std::size_t plane = rgb.width * rgb.height;
  std::vector<float> values(3 * rgb.values.size());
  for (std::size_t i = 0; i < rgb.values.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      values[(i / plane * 3 + c) * plane + i % plane] = rgb.values[i][glm::length_t(c)];
  return values;
}

/// The same colours as the field `spectra`, by colourSpectrum().
std::vector<float> spectralPlanes(const SliceStack<glm::vec3>& rgb) {
  const std::size_t plane = rgb.width * rgb.height, count = spectralBasis().nanometres.size();
  std::vector<float> values(count * rgb.values.size()), spectrum(count);
  for (std::size_t i = 0; i < rgb.values.size(); ++i) {
    colourSpectrum(Rgb(rgb.values[i]), spectrum);
    for (std::size_t k = 0; k < count; ++k) values[(i / plane * count + k) * plane + i % plane] = spectrum[k];
  }
  return values;
}

/// Linear sRGB values as the field `rgb`, or as `spectra` with `wavelengths`.
/// @param rgb one slice per incident direction.
std::vector<TensorField> colourFields(const SliceStack<glm::vec3>& rgb, const ParameterGrid& incident,
                                      RglColours colours) {
  const auto field = [&](const char* name, std::size_t count, const std::vector<float>& planes) {
    return TensorField::floats(name, {incident.phis().size(), incident.thetas().size(), count, rgb.height, rgb.width},
                               planes);
  };
  if (colours == RglColours::rgb) return {field("rgb", 3, colourPlanes(rgb))};
  const std::vector<float>& nanometres = spectralBasis().nanometres;
  return {field("spectra", nanometres.size(), spectralPlanes(rgb)),
          TensorField::floats("wavelengths", {nanometres.size()}, nanometres)};
}

constexpr std::array<std::string_view, 5> colourNames{"description", "rgb", "spectra", "wavelengths", "visible_ndf"};

TensorField ownField(const std::string& name, const io::TensorView& tensor) {
  if (tensor.type == io::TensorType::float16) return TensorField::floats(name, tensor.shape, tensor.floats());
  return {name, tensor.type, tensor.shape, {tensor.bytes.begin(), tensor.bytes.end()}};
}

/// The colours of an edited file. @param file its tables.
std::vector<TensorField> editedFields(const io::TensorFile& file, const RglData& data, const EditedRgl& edited,
                                      RglColours colours) {
  if (colours == RglColours::rgb || !data.spectra) return colourFields(edited.rgb, data.incident, colours);
  return {TensorField::floats("spectra", file.floatField("spectra", 5).shape, SpectralEdit(data, edited.rgb).spectra()),
          TensorField::floats("wavelengths", {data.spectra->nanometres.size()}, data.spectra->nanometres)};
}

}  // namespace

std::vector<std::byte> encodeRglData(const RglData& data, const std::string& description, RglColours colours) {
  const std::vector<float>&phis = data.incident.phis(), &thetas = data.incident.thetas();
  const char jacobian = data.jacobian ? 1 : 0;
  std::vector<TensorField> fields{TensorField::text("description", description),
                                  TensorField::floats("phi_i", {phis.size()}, phis),
                                  TensorField::floats("theta_i", {thetas.size()}, thetas),
                                  field("sigma", data.sigma, {}),
                                  field("ndf", data.ndf, {}),
                                  field("vndf", data.vndf, {phis.size(), thetas.size()}),
                                  field("luminance", data.luminance, {phis.size(), thetas.size()})};
  for (TensorField& colour : colourFields(data.rgb, data.incident, colours)) fields.push_back(std::move(colour));
  fields.push_back(TensorField::text("jacobian", {&jacobian, 1}));
  return io::encodeTensorFile(fields);
}

RglData wholeData(const RglBrdf::Tables& tables) {
  RglData data = tables.data;
  data.vndf = tables.visibleNormals.cellDensity();
  data.luminance = tables.luminance.cellDensity();
  return data;
}

std::vector<std::byte> withColours(std::span<const std::byte> bytes, const RglBrdf::Tables& tables,
                                   const EditedRgl& edited, RglColours colours, const std::string& description) {
  const io::TensorFile file{io::MemorySource(bytes)};
  const bool hasColours = file.contains(colours == RglColours::rgb ? "rgb" : "spectra");
  if (!edited.changed && hasColours && file.contains("vndf") && file.contains("luminance"))
    return {bytes.begin(), bytes.end()};
  const bool newLuminance = edited.changed || !file.contains("luminance");
  std::vector<TensorField> fields{TensorField::text("description", file.text("description") + "\n" + description)};
  for (const auto& [name, tensor] : file.fields())
    if (std::ranges::find(colourNames, name) == colourNames.end() && !(newLuminance && name == "luminance"))
      fields.push_back(ownField(name, tensor));
  const RglData& data = tables.data;
  const std::vector<std::uint64_t> slices{data.incident.phis().size(), data.incident.thetas().size()};
  if (!file.contains("vndf")) fields.push_back(field("vndf", tables.visibleNormals.cellDensity(), slices));
  if (newLuminance) fields.push_back(field("luminance", samplingLuminance(edited.rgb), slices));
  for (TensorField& colour : editedFields(file, data, edited, colours)) fields.push_back(std::move(colour));
  return io::encodeTensorFile(fields);
}

}  // namespace gonio::rgl
