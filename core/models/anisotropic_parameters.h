// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "core/models/cosine_power.h"

/// Pairs of parameters along the grain of a surface (x) and across it (y), and the direction of the grain. If both are
/// equal, the surface is isotropic and the direction has no effect.
namespace gonio::models {

// clang-format off
constexpr ParameterSpec roughnessXParameter(std::string_view formula, std::string_view reference) {
  ParameterSpec spec = roughnessParameter(
      "alpha_x", "Width of the highlight along x, the brushing direction; the highlight of brushed metal is narrow along x and wide across it.",
      formula, reference);
  spec.id = "roughness-x";
  spec.label = "Roughness x";
  return spec;
}
constexpr ParameterSpec roughnessYParameter(std::string_view formula, std::string_view reference) {
  ParameterSpec spec = roughnessParameter("alpha_y", "Width of the highlight along y, across the brushing direction.", formula, reference);
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
  spec.description = "Sharpness of the highlight along x, the brushing direction: large values are glossy.";
  return spec;
}
constexpr ParameterSpec exponentYParameter(std::string_view formula, std::string_view reference) {
  ParameterSpec spec = exponentXParameter(formula, reference);
  spec.id = "exponent-y";
  spec.label = "Shininess y";
  spec.symbol = "n_y";
  spec.description = "Sharpness of the highlight along y, across the brushing direction.";
  spec.isotropicTwin = "exponent-x";
  return spec;
}
/// The period is pi; the hard range is twice as large, so that fits and sliders do not stop at its ends.
constexpr ParameterSpec rotationParameter() {
  return {.id = "rotation", .label = "Rotation", .symbol = "psi", .unit = "rad",
          .softMin = -halfPi, .softMax = halfPi, .hardMin = -pi, .hardMax = pi, .defaultValue = 0,
          .scale = ParameterScale::angle,
          .description = "Brushing direction x: the angle from the surface tangent to x, counter-clockwise.",
          .formula = "h_x, h_y: h turned by -psi about the normal",
          .reference = "Ward 1992, Measuring and Modeling Anisotropic Reflection",
          .anisotropicOnly = true};
}
// clang-format on

/// Indices of the grain's parameters in a model.
struct GrainIndices {
  std::size_t x, y, rotation;
};

/// Parameters of the same surface with x along the narrower axis of the highlight, and a rotation in [-pi/2, pi/2), 0
/// if both axes are equal. For Model::canonical(). @param widthRises true if larger parameters widen the highlight
/// (roughness), false if they narrow it (exponent).
inline ParameterValues alongGrain(ParameterValues values, const GrainIndices& at, bool widthRises) {
  Rgb &x = values.values[at.x], &y = values.values[at.y], &rotation = values.values[at.rotation];
  if (x == y) {
    rotation = Rgb(0);
    return values;
  }
  double angle = rotation.x;
  if ((x.x > y.x) == widthRises) {
    std::swap(x, y);
    angle += halfPi;
  }
  angle -= pi * std::floor(angle / pi + 0.5);
  rotation = Rgb(angle < halfPi ? angle : -halfPi);  // the difference may round up
  return values;
}

/// The parameters followed by (cos, sin, 0) of the rotation: Model::shaderParameters() of models with a grain.
inline std::vector<glm::vec3> withGrainAxis(const ParameterValues& values, std::size_t rotation) {
  std::vector<glm::vec3> result(values.values.begin(), values.values.end());
  const double angle = values.values[rotation].x;
  result.emplace_back(float(std::cos(angle)), float(std::sin(angle)), 0.0f);
  return result;
}

}  // namespace gonio::models
