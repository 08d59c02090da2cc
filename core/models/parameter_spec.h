// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <string_view>

namespace gonio::models {

/// How a slider spreads a range: evenly, by ratios, evenly in degrees, or by the cube root, which is nearly even in
/// lightness (CIE 1976 L*) and reaches 0.
enum class ParameterScale { linear, logarithmic, angle, lightness };
enum class ParameterGroup { diffuse, specular, fresnel, shadowing, layer, coefficients, convention };

/// What a parameter means in any model: by it the artist's controls find what they change.
enum class ParameterRole {
  other,
  body,               ///< strength and colour of the body
  highlight,          ///< strength and colour of a highlight (head-on where it has a strength for the edge too)
  peak,               ///< the same as the value at its peak: its energy grows with the square of its width
  edge,               ///< strength and colour of a highlight toward grazing angles
  coat,               ///< strength and colour of the highlight of a clear coat
  coatEdge,           ///< the same toward grazing angles
  width,              ///< proportional to the width of a highlight
  sharpness,          ///< proportional to the inverse square of the width
  normalReflectance,  ///< F_0 of the highlight before it in the list of parameters
  refractiveIndex     ///< index of refraction of the same
};

/// Everything there is to know of one parameter of a model. Sliders, tooltips, JSON, the command line, fitting and
/// tests all read this record; nothing about a parameter is written anywhere else.
struct ParameterSpec {
  std::string_view id;      ///< key in JSON and on the command line, e.g. "roughness"
  std::string_view label;   ///< for people, e.g. "Roughness"
  std::string_view symbol;  ///< in formulas, e.g. "alpha"
  std::string_view unit;    ///< "1/sr", "rad", or "" for a plain number
  double softMin, softMax;  ///< the range that a slider covers
  double hardMin, hardMax;  ///< the range that typing accepts; values outside are clamped and reported
  double defaultValue;
  ParameterScale scale = ParameterScale::linear;
  ParameterGroup group = ParameterGroup::specular;
  bool perChannel = false;       ///< one value a colour channel (else one value shared by all three)
  bool linear = false;           ///< the BRDF is linear in it (where it is not cut at 0): fitted in closed form
  std::string_view description;  ///< one sentence
  std::string_view formula;      ///< one line
  std::string_view reference;    ///< author, year, equation
  /// A choice between named conventions rather than a number: the value is an index into this list; never fitted.
  std::span<const std::string_view> choices = {};
  /// Where it matters only with one choice of another parameter: the id of that parameter and the index of the choice.
  /// Otherwise a slider is greyed and a fit leaves it at its default.
  std::string_view activeWith = {};
  int activeChoice = 0;
  /// Of the second of two parameters along the axes x and y: the id of the first. A fit to isotropic data sets both
  /// equal.
  std::string_view isotropicTwin = {};
  /// Whether it means nothing where the pairs along x and y are equal: a fit to isotropic data leaves it at its
  /// default.
  bool anisotropicOnly = false;
  ParameterRole role = ParameterRole::other;
};

}  // namespace gonio::models
