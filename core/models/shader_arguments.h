// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "core/models/fresnel.h"
#include "core/models/model.h"

namespace gonio::models {

/// The arguments of a formula, packed for its GLSL into an array `p` of vectors of four.
class ShaderArguments {
 public:
  void add(double value);
  void add(const glm::dvec2& value);
  void add(const Rgb& value);
  void add(const glsl::FresnelTerm& term);
  template <std::size_t size>
  void add(const std::array<Rgb, size>& values) {
    const std::string outer = std::exchange(text_, {});
    for (const Rgb& value : values) add(value);
    const std::string inner = std::exchange(text_, outer);
    append("vec3[" + std::to_string(size) + "](" + inner + ")");
  }

  /// Zeros fill up the last one.
  std::vector<glm::vec4> packed() const;
  /// The arguments in GLSL, e.g. "vec3(p[0].x, p[0].y, p[0].z), p[0].w".
  const std::string& text() const { return text_; }

 private:
  std::vector<float> numbers_;
  std::string text_;

  std::string added(double number);
  void append(const std::string& argument);
};

/// Model::Functions::arguments from a function that returns the arguments of the formula as a tuple.
template <auto tupleOf>
ShaderArguments shaderArguments(const ParameterValues& p) {
  ShaderArguments result;
  std::apply([&](const auto&... each) { (result.add(each), ...); }, tupleOf(p));
  return result;
}

}  // namespace gonio::models
