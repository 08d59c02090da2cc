// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>
#include <initializer_list>
#include <random>
#include <string_view>
#include <utility>

#include "core/models/registry.h"

/// What the tests of the models share.
namespace gonio::models::test_support {

/// The defaults of a model with named parameters replaced, the same in all channels.
inline ParameterValues parametersOf(const Model& model,
                                    std::initializer_list<std::pair<std::string_view, double>> changes) {
  ParameterValues values = defaultParameters(model.spec());
  for (const auto& [id, value] : changes) values.values.at(model.spec().find(id).value()) = Rgb(value);
  return values;
}

inline Direction direction(double thetaDegrees, double phiDegrees) {
  return fromSpherical(radians(thetaDegrees), radians(phiDegrees));
}

/// Uniform over the solid angle of the upper hemisphere.
inline Direction randomDirection(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double z = 1 - uniform(random);
  const double phi = 2 * pi * uniform(random), s = std::sqrt(1 - z * z);
  return {s * std::cos(phi), s * std::sin(phi), z};
}

/// Parameters drawn from the soft ranges, on the scale of each; choices drawn too.
inline ParameterValues randomParameters(const ModelSpec& spec, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  ParameterValues values;
  for (const ParameterSpec& p : spec.parameters) {
    const auto draw = [&] {
      const double u = uniform(random);
      if (p.scale == ParameterScale::logarithmic) return p.softMin * std::pow(p.softMax / p.softMin, u);
      const double value = p.softMin + u * (p.softMax - p.softMin);
      return p.choices.empty() ? value : std::round(value);
    };
    Rgb value(draw());
    if (p.perChannel) value.y = draw(), value.z = draw();
    values.values.push_back(value);
  }
  return values;
}

/// Every parameter at one end of its hard range.
inline ParameterValues randomCorner(const ModelSpec& spec, std::mt19937_64& random) {
  ParameterValues values;
  for (const ParameterSpec& p : spec.parameters) {
    const auto draw = [&] { return random() & 1 ? p.hardMax : p.hardMin; };
    Rgb value(draw());
    if (p.perChannel) value.y = draw(), value.z = draw();
    values.values.push_back(value);
  }
  return values;
}

}  // namespace gonio::models::test_support
