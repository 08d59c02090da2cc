// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <string_view>

namespace gonio::models {

/// Scale of a slider: linear, logarithmic, linear in degrees, or by the cube root, which is nearly uniform in lightness
/// (CIE 1976 L*) and includes 0.
enum class ParameterScale { linear, logarithmic, angle, lightness };
enum class ParameterGroup { diffuse, specular, fresnel, shadowing, layer, coefficients, convention };

/// Meaning of a parameter across models; the artist's controls select parameters by it.
enum class ParameterRole {
  other,
  diffuse,            ///< strength and colour of the diffuse term
  highlight,          ///< strength and colour of a highlight (at normal incidence, if there is an `edge` too)
  peak,               ///< the same, given as the value at the peak: the energy grows with the square of the width
  edge,               ///< strength and colour of a highlight toward grazing angles
  coat,               ///< strength and colour of the highlight of a clear coat
  coatEdge,           ///< strength and colour of a clear coat's highlight toward grazing angles
  width,              ///< proportional to the width of a highlight
  sharpness,          ///< proportional to the inverse square of the width
  normalReflectance,  ///< F_0 of the preceding highlight in the list of parameters
  refractiveIndex     ///< index of refraction of the preceding highlight
};

/// The complete definition of a model's parameter, used by sliders, tooltips, JSON, the command line, fitting and
/// tests.
struct ParameterSpec {
  std::string_view id;      ///< key in JSON and on the command line, e.g. "roughness"
  std::string_view label;   ///< for display, e.g. "Roughness"
  std::string_view symbol;  ///< in formulas, e.g. "alpha"
  std::string_view unit;    ///< "1/sr", "rad", or "" for a number without unit
  double softMin, softMax;  ///< range of a slider
  double hardMin, hardMax;  ///< permitted range; values outside are clamped and reported
  double defaultValue;
  ParameterScale scale = ParameterScale::linear;
  ParameterGroup group = ParameterGroup::specular;
  bool perChannel = false;       ///< one value per colour channel; false: one value for all three
  bool linear = false;           ///< whether the BRDF, before clamping at 0, is linear in it
  std::string_view description;  ///< one sentence
  std::string_view formula;      ///< one line
  std::string_view reference;    ///< author, year, equation
  /// For a choice between named conventions: the value is an index into this list; never fitted.
  std::span<const std::string_view> choices = {};
  /// For a parameter that only has an effect with one choice of another parameter: the id of that parameter, and the
  /// index of the choice. With any other choice, the slider of this parameter is disabled and fits leave it at
  /// its default.
  std::string_view activeWith = {};
  int activeChoice = 0;
  /// For the second of two parameters along the axes x and y: the id of the first. Fits to isotropic data set both
  /// equal.
  std::string_view isotropicTwin = {};
  /// True for a parameter that has no effect if the parameters along x and y are equal (the rotation); fits to
  /// isotropic data leave it at its default.
  bool anisotropicOnly = false;
  ParameterRole role = ParameterRole::other;
};

}  // namespace gonio::models
