// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/math/fast_functions.h"
#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/he_series.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

namespace {

constexpr std::string_view he1991 =
    "He, Torrance, Sillion and Greenberg 1991, A Comprehensive Physical Model for Light Reflection";
constexpr std::string_view seriesFormula =
    "D = sum over m >= 1 of g^m exp(-g - a / m) / (m! m), g = (2 pi sigma (cos theta_i + cos theta_o) / lambda)^2, "
    "a = (2 pi tau cos theta_d sin theta_h / lambda)^2";

/// Dominant wavelengths of the primaries of sRGB, um.
constexpr double wavelengths[] = {0.6114, 0.5491, 0.4643};

enum Index { diffuse, specular, roughness, correlation, refractiveIndex, fresnelTerm, edgeTint };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(1, "k_s pi (tau / lambda)^2 F S D cos^2 theta_d / (cos^2 theta_h cos theta_i cos theta_o)", he1991),
    {.id = "roughness", .label = "Height deviation", .symbol = "sigma_0", .unit = "um",
     .softMin = 0.01, .softMax = 2, .hardMin = 1e-3, .hardMax = 20, .defaultValue = 0.2,
     .scale = ParameterScale::logarithmic,
     .description = "Standard deviation of the height of the surface: the larger, the wider the highlight; below the "
                    "wavelength most light leaves in the mirror direction, which the model omits.",
     .formula = seriesFormula, .reference = he1991},
    {.id = "correlation-length", .label = "Correlation length", .symbol = "tau", .unit = "um",
     .softMin = 0.5, .softMax = 100, .hardMin = 0.05, .hardMax = 500, .defaultValue = 3,
     .scale = ParameterScale::logarithmic,
     .description = "Distance along the surface over which heights are correlated: the larger, the narrower the "
                    "highlight.",
     .formula = seriesFormula, .reference = he1991},
    refractiveIndexParameter(he1991),
    fresnelParameter(FresnelChoice::dielectric),
    edgeTintParameter(),
};

constexpr ModelSpec heSpec = {
    .id = "he", .name = "He-Torrance-Sillion-Greenberg",
    .description = "Wave optics of a surface with Gaussian heights: the directional-diffuse part of the model, "
                   "unpolarised; it depends on the wavelength. Reciprocal. The mirror reflection of smooth "
                   "surfaces is omitted.",
    .formula = "k_d / pi + k_s pi (tau / lambda)^2 F S D cos^2 theta_d / (cos^2 theta_h cos theta_i cos theta_o)",
    .reference = he1991, .parameters = parameters, .dependsOnWavelength = true};
// clang-format on

/// Of the direction of light or viewer.
struct Shadowing {
  double folded;    ///< S / cos theta
  double openings;  ///< K = tan theta erfc(tau cot theta / (2 sigma_0))
};
/// Eq. 23 to 25 (with the exponential that the paper's errata add) and 82. @param slope sigma_0 / tau.
Shadowing shadowingOf(const Direction& w, double slope) {
  const double sine = std::hypot(w.x, w.y), x = w.z / (2 * slope * sine);
  if (!(x < 27)) return {1 / w.z, 0};
  const double hidden = std::erfc(x), seen = 1 - 0.5 * hidden;
  return {seen / (seen * w.z + fastExp(-x * x) * sine * slope / std::sqrt(pi)), sine / w.z * hidden};
}

/// Slope of the Beckmann distribution that the lobe resembles, for sampling.
double beckmannSlope(double sigma, double tau) {
  const double wavelength = wavelengths[1], heights = 4 * pi * sigma / wavelength;
  return std::clamp(wavelength / (2 * pi * tau) * std::max(1.0, heights), 1e-4, 2.0);
}

Fresnel fresnelOf(const ParameterValues& p) {
  return chosenFresnel(p, fresnelTerm, edgeTint, normalReflectanceFromIndex(p.values[refractiveIndex].x));
}

auto arguments(const ParameterValues& p) {
  return std::tuple(p.values[diffuse] / pi, p.values[specular], p.values[roughness].x, p.values[correlation].x,
                    fresnelOf(p));
}

/// The bounds of the formula. With g = C (cos theta_i + cos theta_o)^2 and cos theta_h = (cos theta_i + cos theta_o) /
/// (2 cos theta_d), the quotient S / cos^2 theta_h, of which both parts vanish at the horizon, is 4 cos^2 theta_d C
/// S / g.
///
/// S / g is the mean of u(n) = exp(-a / (n + 1)) / (n + 1)^2 over Poisson's distribution of mean g. u falls with a, and
/// rises and then falls with n; so does the mean with g, since Poisson's distribution does not increase the number of
/// sign changes (Karlin 1968, Total Positivity). It is also at most the largest u, and S / g exp(g) rises with g.
class HeBound final : public ValueBound {
 public:
  explicit HeBound(const ParameterValues& p)
      : kd_(p.values[diffuse] / pi),
        ks_(p.values[specular]),
        sigma_(p.values[roughness].x),
        tau_(p.values[correlation].x),
        fresnel_(fresnelOf(p)) {
    constexpr int parts = 8;
    for (int step = 0; step < steps; ++step) {
      Range& range = folded_[std::size_t(step)] = {noBound, -noBound};
      for (int part = 0; part < parts; ++part) {
        const double low = double(parts * step + part) / (parts * steps), high = low + 1.0 / (parts * steps);
        range = hull(range, Range(1) / Range(low + termAt(high), high + termAt(low)));
      }
    }
  }

  RgbRange over(const PairBox& box) const override {
    const ranges::SurfaceGeometry g(box);
    const ShadowingRange i = shadowingOver(g.cosI), o = shadowingOver(g.cosO);
    const Range c = (i.openings + o.openings) / Range(std::sqrt(8 * pi));
    const Range visible(heVisibleRoughness(c.high), heVisibleRoughness(c.low));
    const Range height = Range(2 * pi * sigma_) * (g.cosI + g.cosO), length = Range(2 * pi * tau_) * g.cosD;
    const Range phase = square(height) * visible, tilt = square(length) * g.sin2H;
    const Range common = Range(pi * tau_ * tau_ * 4 * pi * sigma_ * 4 * pi * sigma_) * square(square(g.cosD)) *
                         visible * ranges::fresnel(fresnel_, g.cosD) * i.folded * o.folded;
    const std::array<Range, 3> means = meansOver(phase, tilt);
    RgbRange result;
    for (int channel = 0; channel < 3; ++channel) {
      const double wave = 1 / (wavelengths[channel] * wavelengths[channel]);
      const Range value =
          Range(kd_[channel]) + Range(ks_[channel] * wave * wave) * common * means[std::size_t(channel)];
      result.low[channel] = value.low;
      result.high[channel] = value.high;
    }
    return result;
  }
  // Large sets contain both ends of the series, so that a large bound does not indicate a peak.
  bool isLocal() const override { return false; }

 private:
  static constexpr double noBound = std::numeric_limits<double>::infinity();
  static constexpr int steps = 256;  ///< of cos theta
  struct ShadowingRange {
    Range folded, openings;
  };

  /// x of shadowingOf().
  double argumentAt(double cosine) const {
    return cosine / (2 * sigma_ / tau_ * std::sqrt(std::max(0.0, 1 - cosine * cosine)));
  }
  /// S / cos theta = 1 / (cos theta + exp(-x^2) sin theta slope / (sqrt(pi) (1 - erfc(x) / 2))): the second term, which
  /// rises with the angle.
  double termAt(double cosine) const {
    const double x = argumentAt(cosine), sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    return x < 27 ? std::exp(-x * x) * sine * sigma_ / tau_ / std::sqrt(pi) / (1 - 0.5 * std::erfc(x)) : 0;
  }
  /// K, which rises with the angle.
  double openingsAt(double cosine) const {
    const double x = argumentAt(cosine);
    return x < 27 ? std::sqrt(std::max(0.0, 1 - cosine * cosine)) / cosine * std::erfc(x) : 0;
  }
  /// shadowingOf() for all directions with these cosines.
  ShadowingRange shadowingOver(const Range& cosines) const {
    const NodeSpan span({cosines.low * steps - 0.5, cosines.high * steps - 0.5}, steps);
    Range folded = folded_[std::size_t(span.first)];
    for (int i = span.first + 1; i <= span.last; ++i) folded = hull(folded, folded_[std::size_t(i)]);
    return {folded, {openingsAt(cosines.high), openingsAt(cosines.low)}};
  }

  /// S / g for each channel. @param phase, tilt g and a times the square of the wavelength.
  std::array<Range, 3> meansOver(const Range& phase, const Range& tilt) const {
    constexpr double step = 1.05, seriesError = 1e-6, smallest = 1e-290;
    const Rgb lengths(wavelengths[0], wavelengths[1], wavelengths[2]), waves = 1.0 / (lengths * lengths);
    const auto meanAt = [&](double g, double a) { return heSeries(g * waves, a * waves) / (g * waves); };
    const Rgb first = meanAt(phase.low, tilt.low), last = meanAt(phase.high, tilt.low);
    const Rgb before = meanAt(phase.low / step, tilt.low), after = meanAt(phase.high * step, tilt.low);
    const Rgb firstTilted = meanAt(phase.low, tilt.high), lastTilted = meanAt(phase.high, tilt.high);
    std::array<Range, 3> means;
    for (int c = 0; c < 3; ++c) {
      const double a = tilt.low * waves[c], ends = std::max(first[c], last[c]);
      const double most = a > 2 ? 4 * std::exp(-2.0) / (a * a) : std::exp(-a);
      const double grown = std::exp(std::min(700.0, (phase.high - phase.low) * waves[c])) * std::max(last[c], smallest);
      const bool isPastMode = first[c] * (1 + seriesError) < before[c];
      const bool isBeforeMode = last[c] * (1 + seriesError) < after[c];
      const double high = isPastMode || isBeforeMode ? std::max(ends, smallest) : std::min(most, grown);
      means[std::size_t(c)] = {std::min(firstTilted[c], lastTilted[c]), high * (1 + seriesError)};
    }
    return means;
  }

  Rgb kd_, ks_;
  double sigma_, tau_;
  ranges::FresnelTerm fresnel_;
  std::array<Range, steps> folded_;
};

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double sigma = p.values[roughness].x, tau = p.values[correlation].x, slope = sigma / tau;
  const Fresnel fresnel = fresnelOf(p);
  const Rgb kd = p.values[diffuse] / pi, ks = p.values[specular];
  const double width = beckmannSlope(sigma, tau);
  const Rgb lengths(wavelengths[0], wavelengths[1], wavelengths[2]), waves = 1.0 / (lengths * lengths);
  const auto evaluate = [=](const SurfaceGeometry& g) {
    const Shadowing i = shadowingOf(g.wi, slope), o = shadowingOf(g.wo, slope);
    const double height = 2 * pi * sigma * (g.cosI + g.cosO), length = 2 * pi * tau * g.cosD;
    const double phase = height * height * heVisibleRoughness((i.openings + o.openings) / std::sqrt(8 * pi));
    const double tilt = length * length * g.sin2H, ratio = g.cosD / g.h.z;
    const double common = pi * tau * tau * fresnel(g.cosD) * ratio * ratio * i.folded * o.folded;
    const Rgb lobe = waves * heSeries(phase * waves, tilt * waves);
    return kd + ks * lobe * common;
  };
  struct Bounded : decltype(evaluate) {
    ParameterValues parameters;
    std::shared_ptr<const ValueBound> valueBound() const { return std::make_shared<const HeBound>(parameters); }
  };
  return makeGeometryBrdf(Bounded{evaluate, p}, diffuseMixture(maxChannel(p.values[diffuse]),
                                                               maxChannel(p.values[specular]) * fresnel(typicalCosine),
                                                               HalfVectorDensity{BeckmannNormals{width, width}}));
}

}  // namespace

const Model& he() {
  static const Model model(heSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
