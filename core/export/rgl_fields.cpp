// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/rgl_fields.h"

#include "core/export/rgb_spectra.h"

namespace gonio::exports {

namespace {

using io::TensorField;

/// [phi][theta][plane][row][column], each plane a weighted sum of the channels.
std::vector<float> planes(const SliceStack<glm::vec3>& rgb, std::span<const Rgb> weights) {
  const std::size_t slice = rgb.width * rgb.height;
  std::vector<float> values;
  values.reserve(rgb.values.size() * weights.size());
  for (std::size_t start = 0; start < rgb.values.size(); start += slice)
    for (const Rgb& weight : weights)
      for (std::size_t node = 0; node < slice; ++node)
        values.push_back(float(glm::dot(weight, Rgb(rgb.values[start + node]))));
  return values;
}

TensorField field(const std::string& name, const SliceStack<float>& stack, std::vector<std::uint64_t> slices) {
  slices.insert(slices.end(), {stack.height, stack.width});
  return TensorField::floats(name, std::move(slices), stack.values);
}

}  // namespace

std::vector<TensorField> colourFields(const SliceStack<glm::vec3>& rgb, const ParameterGrid& incident,
                                      RglColours colours) {
  const auto colourField = [&](const char* name, std::span<const Rgb> weights) {
    return TensorField::floats(
        name, {incident.phis().size(), incident.thetas().size(), weights.size(), rgb.height, rgb.width},
        planes(rgb, weights));
  };
  if (colours == RglColours::rgb) return {colourField("rgb", std::vector<Rgb>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})};
  const SpectralBasis& basis = spectralBasis();
  return {colourField("spectra", basis.values),
          TensorField::floats("wavelengths", {basis.nanometres.size()}, basis.nanometres)};
}

std::vector<TensorField> rglFields(const RglData& data, const std::string& description, RglColours colours) {
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
  return fields;
}

RglData wholeData(const RglBrdf::Tables& tables) {
  RglData data = tables.data;
  data.vndf = tables.visibleNormals.cellDensity();
  data.luminance = tables.luminance.cellDensity();
  return data;
}

}  // namespace gonio::exports
