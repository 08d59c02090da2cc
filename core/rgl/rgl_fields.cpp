// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rgl/rgl_fields.h"

#include <algorithm>
#include <array>

#include "core/rgl/rgb_spectra.h"
#include "core/rgl/spectral_edit.h"

namespace gonio::rgl {

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

TensorField ownField(const std::string& name, const io::Tensor& tensor) {
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
