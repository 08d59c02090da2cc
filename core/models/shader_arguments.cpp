// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/shader_arguments.h"

#include <algorithm>

namespace gonio::models {

void ShaderArguments::add(double value) { append(added(value)); }

void ShaderArguments::add(const glm::dvec2& value) {
  const std::string x = added(value.x), y = added(value.y);
  append("vec2(" + x + ", " + y + ")");
}

void ShaderArguments::add(const Rgb& value) {
  const std::string x = added(value.x), y = added(value.y), z = added(value.z);
  append("vec3(" + x + ", " + y + ", " + z + ")");
}

void ShaderArguments::add(const glsl::FresnelTerm& term) {
  // The squares of both stay in the range of float; from here on the reflectance is 1.
  constexpr double most = 1e18;
  std::string inner;
  for (const double number : {term.exactFraction, std::min(term.contrast, most), std::min(term.product, most),
                              term.constant, term.risingFraction})
    inner += (inner.empty() ? "" : ", ") + added(number);
  append("FresnelTerm(" + inner + ")");
}

std::vector<glm::vec4> ShaderArguments::packed() const {
  std::vector<glm::vec4> result((numbers_.size() + 3) / 4);
  for (std::size_t i = 0; i < numbers_.size(); ++i) result[i / 4][glm::length_t(i % 4)] = numbers_[i];
  return result;
}

std::string ShaderArguments::added(double number) {
  const std::size_t at = numbers_.size();
  numbers_.push_back(float(number));
  return "p[" + std::to_string(at / 4) + "]." + "xyzw"[at % 4];
}

void ShaderArguments::append(const std::string& argument) { text_ += (text_.empty() ? "" : ", ") + argument; }

}  // namespace gonio::models
