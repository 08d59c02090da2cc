// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cmath>

#include "core/math/fast_functions.h"
#include "core/models/common_parameters.h"
#include "core/models/exponential_power.h"
#include "core/models/registry.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

namespace {

constexpr std::string_view holzschuchPacanowski2017 =
    "Holzschuch and Pacanowski 2017, A Two-Scale Microfacet Reflectance Model Combining Reflection and Diffraction";
constexpr std::string_view facetsFormula =
    "D = p / (pi beta^2 Gamma(1/p)) exp(-(tan^2 theta_h / beta^2)^p) / cos^4 theta_h";
constexpr std::string_view shareFormula = "A = exp(-(4 pi sigma_s cos theta_d / lambda)^2)";
constexpr std::string_view lobeFormula =
    "S = 2 (c - 1) / pi v M (1 + 4 v C sin^2 theta_h)^(-(c + 1) / 2), C = cos^2 theta_d, w = (lambda / b)^2, "
    "1 / v = w + C (2 w + C t) / (w / a + C), a = (c + 1) E[tan^2 theta_h], t = 2 (c - 1) / (pi D(0)), "
    "M = w v cos theta_i cos theta_o + (1 - w v) C cos^2 theta_h";

/// Dominant wavelengths of the primaries of sRGB, um.
constexpr double wavelengths[] = {0.6114, 0.5491, 0.4643};

enum Index {
  diffuse,
  specular,
  roughness,
  power,
  normalReflectance,
  nanoRoughness,
  correlation,
  falloff,
  fresnelTerm,
  edgeTint
};

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.1),
    specularParameter(1, "k_s F G (A D + (1 - A) S) / (4 cos theta_i cos theta_o)", holzschuchPacanowski2017),
    roughnessParameter("beta", "Width of the highlight: the slopes of the facets.", facetsFormula,
                       holzschuchPacanowski2017, 5, 0.05),
    {.id = "power", .label = "Roundness", .symbol = "p", .unit = "",
     .softMin = 0.2, .softMax = 2, .hardMin = ExponentialPowerDistribution::minPower,
     .hardMax = ExponentialPowerDistribution::maxPower, .defaultValue = 0.7,
     .scale = ParameterScale::logarithmic,
     .description = "Shape of the highlight: small values give a sharp peak with wide tails, large ones a flat top; 1 "
                    "is Beckmann.",
     .formula = facetsFormula, .reference = holzschuchPacanowski2017},
    normalReflectanceParameter(0.5),
    {.id = "nano-roughness", .label = "Nano roughness", .symbol = "sigma_s", .unit = "nm",
     .softMin = 0, .softMax = 100, .hardMin = 0, .hardMax = 1000, .defaultValue = 20,
     .group = ParameterGroup::layer,
     .description = "Height of the details smaller than a wavelength: moves light from the highlight to a bluish glow "
                    "around it.",
     .formula = shareFormula, .reference = holzschuchPacanowski2017},
    {.id = "correlation-length", .label = "Nano scale", .symbol = "b", .unit = "um",
     .softMin = 0.1, .softMax = 20, .hardMin = 1e-3, .hardMax = 1e3, .defaultValue = 1,
     .scale = ParameterScale::logarithmic, .group = ParameterGroup::layer,
     .description = "Extent of the details smaller than the facets: the larger, the closer the glow stays to the "
                    "highlight.",
     .formula = lobeFormula, .reference = holzschuchPacanowski2017},
    {.id = "falloff", .label = "Nano falloff", .symbol = "c", .unit = "",
     .softMin = 1.05, .softMax = 3, .hardMin = 1.001, .hardMax = 10, .defaultValue = 1.5,
     .group = ParameterGroup::layer,
     .description = "How fast the glow falls off: small values leave it wide.",
     .formula = lobeFormula, .reference = holzschuchPacanowski2017},
    fresnelParameter(FresnelChoice::conductor),
    edgeTintParameter(),
};

constexpr ModelSpec holzschuchPacanowskiSpec = {
    .id = "holzschuch-pacanowski", .name = "Holzschuch-Pacanowski",
    .description = "Specular facets with details that diffract: the highlight has Smith masking and an exponential "
                   "power distribution; the glow depends on the wavelength. Reciprocal. Simplified: a closed form for "
                   "the blur of the glow by the facets; the Fresnel term instead of the polarisation factor of the "
                   "glow; no compensation for the loss of the glow at the horizon. The model gains up to 18 % of "
                   "energy at grazing angles where the details are rough and the facets flat.",
    .formula = "k_d / pi + k_s F G (A D + (1 - A) S) / (4 cos theta_i cos theta_o)",
    .reference = holzschuchPacanowski2017, .parameters = parameters, .dependsOnWavelength = true,
    // The power under the exponential of the facets multiplies the rounding of the logarithm.
    .floatError = {.relative = 1e-4}};
// clang-format on

/// The glow of one colour: the paper's K-correlation lobe, convolved with the facets. Here the convolution is a lobe of
/// the same form and energy, whose peak is right in value and first order for narrow facets, right for wide ones, and a
/// rational function of their width between: within a quarter while the facets are no wider than the glow, 2 % for
/// Beckmann's.
struct Diffraction {
  double phase;         ///< (4 pi sigma_s / lambda)^2
  double spread;        ///< w = (lambda / b)^2
  double spreadOfBlur;  ///< w / a
  double widestBlur;    ///< t
  double exponent;      ///< (c + 1) / 2
  double strength;      ///< 2 (c - 1) / pi

  double highlightFraction(double cosD) const { return fastExp(-phase * cosD * cosD); }
  /// (1 - A) S. @param cosines product of those of the polar angles.
  double glow(double sin2H, double cosH, double cosD, double cosines) const {
    const double cos2D = cosD * cosD;
    const double v = 1 / (spread + cos2D * (2 * spread + cos2D * widestBlur) / (spreadOfBlur + cos2D));
    // The facet that the light meets: the surface itself where facets hardly tilt, the mirroring one where the glow is
    // narrow against them.
    const double flat = spread * v, projected = flat * cosines + (1 - flat) * cos2D * cosH * cosH;
    const double fraction = -fastExpm1(-std::min(phase * cos2D, 700.0));
    return fraction * strength * v * projected * fastExp(-exponent * fastLog1p(4 * v * cos2D * sin2H));
  }
};

Diffraction makeDiffraction(const ParameterValues& p, const ExponentialPowerDistribution& facets, int channel) {
  const double c = p.values[falloff].x, root = 4 * pi * p.values[nanoRoughness].x * 1e-3 / wavelengths[channel];
  const double ratio = wavelengths[channel] / p.values[correlation].x, strength = 2 * (c - 1) / pi;
  return {.phase = root * root,
          .spread = ratio * ratio,
          .spreadOfBlur = ratio * ratio / ((c + 1) * facets.meanSquareSlope()),
          .widestBlur = strength * std::exp(-facets.logPeak()),
          .exponent = (c + 1) / 2,
          .strength = strength};
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const ExponentialPowerDistribution facets(p.values[roughness].x, p.values[power].x);
  const std::array<Diffraction, 3> nano{makeDiffraction(p, facets, 0), makeDiffraction(p, facets, 1),
                                        makeDiffraction(p, facets, 2)};
  const Rgb kd = p.values[diffuse] / pi, ks = p.values[specular] / 4.0;
  const Fresnel fresnel = chosenFresnel(p, fresnelTerm, edgeTint, p.values[normalReflectance].x);
  const TabulatedNormals normals([&](double thetaH) {
    const double sine = std::sin(thetaH), cosine = std::cos(thetaH);
    const double mirrored = nano[1].highlightFraction(typicalCosine) * facets.density(sine * sine, cosine);
    return (mirrored + nano[1].glow(sine * sine, cosine, typicalCosine, typicalCosine * typicalCosine)) * cosine;
  });
  return makeGeometryBrdf(
      TwoSteps{[=](const SurfaceGeometry& g) { return smithMaskingOverCosines(g, facets); },
               [=](const SurfaceGeometry& g, double masking) {
                 const double density = facets.density(g.sin2H, g.h.z), common = fresnel(g.cosD) * masking;
                 const auto lobe = [&](const Diffraction& d) {
                   return d.highlightFraction(g.cosD) * density + d.glow(g.sin2H, g.h.z, g.cosD, g.cosI * g.cosO);
                 };
                 return kd + ks * Rgb(lobe(nano[0]), lobe(nano[1]), lobe(nano[2])) * common;
               }},
      diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(p.values[specular]) * fresnel(typicalCosine),
                     HalfVectorDensity{normals}));
}

/// The shader has no gamma function and no quadrature: ln D(0), the mean slope, the mean square slope, and the
/// masking's nodes, three an entry.
auto arguments(const ParameterValues& p) {
  const ExponentialPowerDistribution facets(p.values[roughness].x, p.values[power].x);
  std::array<Rgb, ExponentialPowerDistribution::maskingNodes / 3> nodes;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    nodes[n] = {facets.masking()[3 * n], facets.masking()[3 * n + 1], facets.masking()[3 * n + 2]};
  return std::tuple(p.values[diffuse] / pi, p.values[specular], p.values[roughness].x, p.values[power].x,
                    p.values[nanoRoughness].x, p.values[correlation].x, p.values[falloff].x,
                    chosenFresnel(p, fresnelTerm, edgeTint, p.values[normalReflectance].x),
                    Rgb(facets.logPeak(), facets.meanSlope(), facets.meanSquareSlope()), nodes);
}

}  // namespace

const Model& holzschuchPacanowski() {
  static const Model model(holzschuchPacanowskiSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
