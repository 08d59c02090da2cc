// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/models/cosine_power.h"

/// Pairs of parameters along the tangent x and the bitangent y. Both equal: an isotropic surface.
namespace gonio::models {

// clang-format off
constexpr ParameterSpec roughnessXParameter(std::string_view formula, std::string_view reference) {
  ParameterSpec spec = roughnessParameter(
      "alpha_x", "Width of the highlight along the tangent; brushed metal is narrow along one axis, wide along the other.",
      formula, reference);
  spec.id = "roughness-x";
  spec.label = "Roughness x";
  return spec;
}
constexpr ParameterSpec roughnessYParameter(std::string_view formula, std::string_view reference) {
  ParameterSpec spec = roughnessParameter("alpha_y", "Width of the highlight along the bitangent.", formula, reference);
  spec.id = "roughness-y";
  spec.label = "Roughness y";
  spec.isotropicTwin = "roughness-x";
  return spec;
}
constexpr ParameterSpec exponentXParameter(std::string_view formula, std::string_view reference) {
  ParameterSpec spec = exponentParameter(formula, reference);
  spec.id = "exponent-x";
  spec.label = "Shininess x";
  spec.symbol = "n_x";
  spec.softMax = 1e5;
  spec.defaultValue = 100;
  spec.description = "Sharpness of the highlight along the tangent: large is glossy.";
  return spec;
}
constexpr ParameterSpec exponentYParameter(std::string_view formula, std::string_view reference) {
  ParameterSpec spec = exponentXParameter(formula, reference);
  spec.id = "exponent-y";
  spec.label = "Shininess y";
  spec.symbol = "n_y";
  spec.description = "Sharpness of the highlight along the bitangent.";
  spec.isotropicTwin = "exponent-x";
  return spec;
}
// clang-format on

}  // namespace gonio::models
