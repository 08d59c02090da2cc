// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/fast_functions.h"
#include "core/math/quadrature.h"
#include "core/models/common_parameters.h"
#include "core/models/registry.h"
#include "core/models/v_cavity.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

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

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double m = p.values[roughness].x, inverseM2 = 1 / (m * m), density = facetDensity(p);
  const Rgb kd = p.values[diffuse] / pi, ks = p.values[specular] * (density / 4);
  const Fresnel fresnel = chosenFresnel(p, fresnelTerm, edgeTint, p.values[normalReflectance].x);
  const double albedo = maxChannel(p.values[specular]) * density * facetArea(m) * fresnel(typicalCosine);
  return makeGeometryBrdf(
      [=](const SurfaceGeometry& g) {
        const double thetaH = fastAtan2(std::sqrt(g.sin2H), g.half.z);
        return kd + ks * (fastExp(-thetaH * thetaH * inverseM2) * fresnel(g.cosD) * vCavityOverCosines(g));
      },
      diffuseMixture(maxChannel(p.values[diffuse]), albedo, HalfVectorDensity{TabulatedNormals([=](double thetaH) {
                       return std::exp(-thetaH * thetaH * inverseM2) * std::cos(thetaH);
                     })}));
}

/// K stands behind the values: the shader does no quadrature.
std::vector<glm::vec3> shaderParameters(const ParameterValues& p) {
  std::vector<glm::vec3> result(p.values.begin(), p.values.end());
  result.emplace_back(float(facetDensity(p)));
  return result;
}

}  // namespace

const Model& torranceSparrow() {
  static const Model model(torranceSparrowSpec, {.create = create, .shaderParameters = shaderParameters});
  return model;
}

}  // namespace gonio::models
