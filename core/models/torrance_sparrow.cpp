// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>

#include "core/math/quadrature.h"
#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

namespace glsl {
#include "core/models/torrance_sparrow.glsl"
}
namespace ranges {
#include "core/models/torrance_sparrow.glsl"
}

namespace {

constexpr std::string_view torranceSparrow1967 =
    "Torrance and Sparrow 1967, Theory for Off-Specular Reflection from Roughened Surfaces, eq. 22-23";
constexpr std::string_view normalisations[] = {"unit-area", "original-1967"};

enum Index { diffuse, specular, roughness, normalReflectance, fresnelTerm, edgeTint, normalisation };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(1, "k_s D F G / (4 cos theta_i cos theta_o)", torranceSparrow1967),
    roughnessParameter("m",
                       "Width of the highlight: the tilt of the facets, in radians, at which their distribution falls "
                       "to 1/e of its peak.",
                       "D = K exp(-theta_h^2 / m^2)", torranceSparrow1967),
    normalReflectanceParameter(),
    fresnelParameter(FresnelChoice::conductor),
    edgeTintParameter(),
    choiceParameter("normalisation", "Normalisation", "K",
                    "Normalises the facets to cover the surface exactly, so that the energy does not depend on the "
                    "width.",
                    "unit-area: the integral of D cos theta_h over the hemisphere is 1; original-1967: K = 1",
                    torranceSparrow1967, normalisations),
};

constexpr ModelSpec torranceSparrowSpec = {
    .id = "torrance-sparrow", .name = "Torrance-Sparrow",
    .description = "Facets with a Gaussian distribution of tilt angles and V-cavity masking: the first microfacet "
                   "model. Reciprocal; conserves energy with normalisation 'unit-area'; with 'original-1967' the "
                   "strength is arbitrary.",
    .formula = "k_d / pi + k_s D F G / (4 cos theta_i cos theta_o)", .reference = torranceSparrow1967,
    .parameters = parameters, .conservesEnergy = true};
// clang-format on

/// The integral of exp(-theta^2 / m^2) cos theta over the hemisphere, by Gauss-Legendre over the core of the Gaussian.
double facetArea(double m) {
  static const QuadratureRule unit = gaussLegendre(24, 0, 1);
  const double end = std::min(halfPi, 7 * m);
  return pi * end * unit.integrate([&](double x) {
    const double theta = end * x;
    return std::exp(-(theta / m) * (theta / m)) * std::sin(2 * theta);
  });
}

double facetDensity(const ParameterValues& p) {
  return chosen(p.values[normalisation].x) == 0 ? 1 / facetArea(p.values[roughness].x) : 1;
}

auto arguments(const ParameterValues& p) {
  const double m = p.values[roughness].x;
  return std::tuple(p.values[diffuse] / pi, p.values[specular] * (facetDensity(p) / 4), 1 / (m * m),
                    chosenFresnel(p, fresnelTerm, edgeTint, p.values[normalReflectance].x));
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double m = p.values[roughness].x;
  const Fresnel fresnel = chosenFresnel(p, fresnelTerm, edgeTint, p.values[normalReflectance].x);
  const double albedo = maxChannel(p.values[specular]) * facetDensity(p) * facetArea(m) * fresnel(typicalCosine);
  return makeGeometryBrdf(
      bound<glsl::formula_torrance_sparrow, ranges::formula_torrance_sparrow>(arguments(p)),
      diffuseMixture(maxChannel(p.values[diffuse]), albedo, HalfVectorDensity{TabulatedNormals([m](double thetaH) {
                       return std::exp(-thetaH * thetaH / (m * m)) * std::cos(thetaH);
                     })}));
}

}  // namespace

const Model& torranceSparrow() {
  static const Model model(torranceSparrowSpec, {.create = create, .arguments = shaderArguments<arguments>});
  return model;
}

}  // namespace gonio::models
