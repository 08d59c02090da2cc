// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <string_view>

namespace gonio::models {

enum class ParameterScale { linear, logarithmic, angle };
enum class ParameterGroup { diffuse, specular, fresnel, shadowing, layer, coefficients, convention };

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
};

}  // namespace gonio::models
