// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/special_functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/models/registry.h"
#include "core/models/shader_arguments.h"
#include "core/models/surface_geometry.h"

namespace gonio::models {

namespace {

/// Bands 0 to 4: matte and broadly glossy materials. A sharper highlight would need hundreds of coefficients.
constexpr int bands = 5;

constexpr std::string_view westin =
    "Westin, Arvo and Torrance 1992, Predicting Reflectance Functions from Complex Surfaces, section 4";
constexpr std::string_view formulaText =
    "max(0, sum_m sum_(l >= l') c (w_l w_l' / 2) (y_lm(i) y_l'm(o) + y_l'm(i) y_lm(o) + the same for -m))";

/// One coefficient: it ties band `high` of one direction to band `low` of the other, at order m.
struct Term {
  int m, high, low;
};
constexpr std::size_t termCount() {
  std::size_t count = 0;
  for (int m = 0; m < bands; ++m) count += std::size_t(bands - m) * std::size_t(bands - m + 1) / 2;
  return count;
}
constexpr std::array<Term, termCount()> makeTerms() {
  std::array<Term, termCount()> terms{};
  std::size_t at = 0;
  for (int m = 0; m < bands; ++m)
    for (int high = m; high < bands; ++high)
      for (int low = m; low <= high; ++low) terms[at++] = {m, high, low};
  return terms;
}
constexpr std::array<Term, termCount()> terms = makeTerms();
constexpr std::size_t window = terms.size();  ///< the parameter behind the coefficients

/// The specs and the texts that they view.
struct Specs {
  std::array<std::string, termCount()> ids, labels, symbols, descriptions;
  std::array<ParameterSpec, termCount() + 1> parameters;
  ModelSpec model;

  Specs();
};

Specs::Specs() {
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const std::string high = std::to_string(terms[i].high), low = std::to_string(terms[i].low);
    const std::string m = std::to_string(terms[i].m);
    ids[i] = "c-" + high + "-" + low + "-" + m;
    labels[i] = "Bands " + high + ", " + low + ", order " + m;
    symbols[i] = "c_" + high + "," + low + "^" + m;
    descriptions[i] = "Coefficient of band " + high + " of one direction and band " + low +
                      " of the other, with azimuthal order " + m + " about the normal.";
    // The first makes a matte surface of albedo 0.2: its basis is 1 / (4 pi).
    parameters[i] = {.id = ids[i],
                     .label = labels[i],
                     .symbol = symbols[i],
                     .unit = "",
                     .softMin = -2,
                     .softMax = 2,
                     .hardMin = -1e4,
                     .hardMax = 1e4,
                     .defaultValue = i == 0 ? 0.8 : 0.0,
                     .group = ParameterGroup::coefficients,
                     .perChannel = true,
                     .linear = true,
                     .description = descriptions[i],
                     .formula = formulaText,
                     .reference = westin};
  }
  parameters[window] = {
      .id = "window",
      .label = "Smoothing",
      .symbol = "s",
      .unit = "",
      .softMin = 0,
      .softMax = 1,
      .hardMin = 0,
      .hardMax = 1,
      .defaultValue = 0,
      .description = "Fades the higher bands (a Hann window), which removes ripples and some sharpness.",
      .formula = "w_l = 1 - s (1 - cos(pi l / 5)) / 2",
      .reference = "Harris 1978, On the Use of Windows for Harmonic Analysis"};
  model = {.id = "spherical-harmonics",
           .name = "Spherical harmonics",
           .description =
               "A series of real spherical harmonics of both directions, bands 0 to 4, isotropic. Represents any "
               "smooth shape; sharp highlights cause ringing. Clamped to 0 where it would be negative. "
               "Reciprocal; nothing bounds the energy.",
           .formula = formulaText,
           .reference = westin,
           .parameters = parameters,
           .family = ModelFamily::series,
           // The terms, up to about 100 times one in size, cancel each other.
           .floatError = {.absolute = 5e-6}};
}

double windowOf(int band, double smoothing) { return 1 - smoothing * (1 - std::cos(pi * band / bands)) / 2; }

using Coefficients = std::array<Rgb, termCount()>;

/// The coefficients with window and the factors of the real harmonics: for m > 0 the pair of +m and -m gives
/// 2 q q' Re((x_i + i y_i)(x_o - i y_o))^m.
Coefficients windowed(const ParameterValues& p) {
  Coefficients result;
  const double smoothing = p.values[window].x;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const auto [m, high, low] = terms[i];
    result[i] = p.values[i] * (windowOf(high, smoothing) * windowOf(low, smoothing) * (m > 0 ? 1.0 : 0.5));
  }
  return result;
}

Rgb evaluateSeries(const Coefficients& coefficients, const SurfaceGeometry& g) {
  std::array<double, harmonicCount(bands)> qi, qo;
  normalisedLegendre(bands, g.cosI, qi);
  normalisedLegendre(bands, g.cosO, qo);
  // (x_i + i y_i)(x_o - i y_o) = sin theta_i sin theta_o e^(i dphi): its powers need no angle.
  const double real = g.wi.x * g.wo.x + g.wi.y * g.wo.y, imaginary = g.wi.y * g.wo.x - g.wi.x * g.wo.y;
  double powerReal = 1, powerImaginary = 0;
  Rgb sum(0);
  std::size_t at = 0;
  for (int m = 0; m < bands; ++m) {
    for (int high = m; high < bands; ++high)
      for (int low = m; low <= high; ++low) {
        const std::size_t h = harmonicIndex(bands, high, m), l = harmonicIndex(bands, low, m);
        sum += coefficients[at++] * (powerReal * (qi[h] * qo[l] + qi[l] * qo[h]));
      }
    const double next = powerReal * real - powerImaginary * imaginary;
    powerImaginary = powerReal * imaginary + powerImaginary * real;
    powerReal = next;
  }
  return sum;
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  return makeGeometryBrdf([c = windowed(p)](const SurfaceGeometry& g) { return glm::max(evaluateSeries(c, g), 0.0); });
}

std::unique_ptr<const Brdf> createUnclamped(const ParameterValues& p) {
  return makeGeometryBrdf([c = windowed(p)](const SurfaceGeometry& g) { return evaluateSeries(c, g); });
}

/// The window is in the coefficients.
auto arguments(const ParameterValues& p) { return std::tuple(windowed(p)); }

}  // namespace

const Model& sphericalHarmonics() {
  static const Specs specs;
  static const Model model(
      specs.model, {.create = create, .arguments = shaderArguments<arguments>, .createUnclamped = createUnclamped});
  return model;
}

}  // namespace gonio::models
