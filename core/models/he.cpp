// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>

#include "core/math/fast_functions.h"
#include "core/models/common_parameters.h"
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

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double sigma = p.values[roughness].x, tau = p.values[correlation].x, slope = sigma / tau;
  const Fresnel fresnel = fresnelOf(p);
  const Rgb kd = p.values[diffuse] / pi, ks = p.values[specular];
  const double width = beckmannSlope(sigma, tau);
  const Rgb lengths(wavelengths[0], wavelengths[1], wavelengths[2]), waves = 1.0 / (lengths * lengths);
  return makeGeometryBrdf(
      [=](const SurfaceGeometry& g) {
        const Shadowing i = shadowingOf(g.wi, slope), o = shadowingOf(g.wo, slope);
        const double height = 2 * pi * sigma * (g.cosI + g.cosO), length = 2 * pi * tau * g.cosD;
        const double phase = height * height * heVisibleRoughness((i.openings + o.openings) / std::sqrt(8 * pi));
        const double tilt = length * length * g.sin2H, ratio = g.cosD / g.h.z;
        const double common = pi * tau * tau * fresnel(g.cosD) * ratio * ratio * i.folded * o.folded;
        const Rgb lobe = waves * heSeries(phase * waves, tilt * waves);
        return kd + ks * lobe * common;
      },
      diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(p.values[specular]) * fresnel(typicalCosine),
                     HalfVectorDensity{BeckmannNormals{width, width}}));
}

}  // namespace

const Model& he() {
  static const Model model(heSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
