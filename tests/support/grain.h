// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>
#include <vector>

#include "core/brdf/utia_brdf.h"
#include "core/models/registry.h"

/// Anisotropic materials without a measurement: no measured one is at hand.
namespace gonio::test {

/// A surface with a grain. The widths are roughnesses, or exponents where the model has those.
struct Grain {
  std::string_view model;
  double x, y, rotation;  ///< rad
};

inline models::ParameterValues grainParameters(const Grain& grain) {
  const models::ModelSpec& spec = models::findModel(grain.model).spec();
  models::ParameterValues values = models::defaultParameters(spec);
  const auto set = [&](std::string_view id, const Rgb& value) {
    if (const auto index = spec.find(id)) values.values[*index] = value;
  };
  set("diffuse", Rgb(0.05, 0.1, 0.02));
  set("specular", Rgb(0.9, 0.6, 0.3));
  set("f0", Rgb(0.6));
  for (const char* id : {"roughness-x", "exponent-x"}) set(id, Rgb(grain.x));
  for (const char* id : {"roughness-y", "exponent-y"}) set(id, Rgb(grain.y));
  set("rotation", Rgb(grain.rotation));
  return values;
}

inline std::unique_ptr<const Brdf> grainBrdf(const Grain& grain) {
  return models::findModel(grain.model).instantiate(grainParameters(grain));
}

/// What a file of the UTIA database would hold of it: its values at 288 x 288 directions.
inline std::vector<glm::vec3> utiaValuesOf(const Brdf& brdf) {
  std::vector<Direction> directions;
  for (std::size_t polar = 0; polar < UtiaBrdf::polarCount; ++polar)
    for (std::size_t azimuth = 0; azimuth < UtiaBrdf::azimuthCount; ++azimuth)
      directions.push_back(fromSpherical(double(polar) * UtiaBrdf::polarStep, double(azimuth) * UtiaBrdf::azimuthStep));
  std::vector<glm::vec3> values;
  for (const Direction& wi : directions)
    for (const Direction& wo : directions) values.emplace_back(brdf.evaluate(wi, wo));
  return values;
}

inline std::shared_ptr<const UtiaBrdf> asUtia(const Brdf& brdf) {
  return std::make_shared<const UtiaBrdf>(utiaValuesOf(brdf));
}

/// The `.bin` file: a plane of doubles for each channel.
inline void writeUtiaFile(const Brdf& brdf, const std::filesystem::path& path) {
  const std::vector<glm::vec3> values = utiaValuesOf(brdf);
  std::ofstream file(path, std::ios::binary);
  for (int channel = 0; channel < 3; ++channel)
    for (const glm::vec3& value : values) {
      const double number = value[channel];
      file.write(reinterpret_cast<const char*>(&number), sizeof number);
    }
}

}  // namespace gonio::test
