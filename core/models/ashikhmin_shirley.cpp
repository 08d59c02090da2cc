// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cmath>

#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"
#include "core/sampling/direction_densities.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

namespace glsl {
#include "core/models/ashikhmin_shirley.glsl"
}
namespace ranges {
#include "core/models/ashikhmin_shirley.glsl"
}

namespace {

constexpr std::string_view ashikhmin2000 = "Ashikhmin and Shirley 2000, An Anisotropic Phong BRDF Model";
constexpr std::string_view diffuseTerms[] = {"coupled", "lambert"};

enum Index { diffuse, specular, exponentX, exponentY, normalReflectance, fresnelTerm, edgeTint, diffuseTerm, rotation };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(1,
                      "k_s sqrt((n_x + 1)(n_y + 1)) / (8 pi) cos^e theta_h F / "
                      "(cos theta_d max(cos theta_i, cos theta_o))",
                      ashikhmin2000),
    exponentXParameter("e = (n_x h_x^2 + n_y h_y^2) / (1 - h_z^2)", ashikhmin2000),
    exponentYParameter("e = (n_x h_x^2 + n_y h_y^2) / (1 - h_z^2)", ashikhmin2000),
    normalReflectanceParameter(),
    fresnelParameter(FresnelChoice::schlick),
    edgeTintParameter(),
    choiceParameter("diffuse-term", "Diffuse term", "R_d",
                    "Light that the diffuse term receives: only what the highlight leaves, or all (fits of Ngan et al. "
                    "2005 and Löw et al. 2012).",
                    "coupled: 28 k_d / (23 pi) (1 - F_0)(1 - (1 - cos theta_i / 2)^5)(1 - (1 - cos theta_o / 2)^5); "
                    "lambert: k_d / pi",
                    ashikhmin2000, diffuseTerms),
    rotationParameter(),
};

constexpr ModelSpec ashikhminShirleySpec = {
    .id = "ashikhmin-shirley", .name = "Ashikhmin-Shirley",
    .description = "Anisotropic Phong lobe about the half vector with a Fresnel term and a diffuse term that "
                   "receives only the light that the highlight leaves. Reciprocal; the albedo of the highlight never "
                   "exceeds k_s and falls towards grazing angles.",
    .formula = "R_d + k_s sqrt((n_x + 1)(n_y + 1)) / (8 pi) cos^e theta_h F / "
               "(cos theta_d max(cos theta_i, cos theta_o)), e = (n_x h_x^2 + n_y h_y^2) / (1 - h_z^2)",
    .reference = ashikhmin2000, .parameters = parameters,
    .family = ModelFamily::empirical, .conservesEnergy = true, .constantError = 0.02};
// clang-format on

Fresnel fresnelOf(const ParameterValues& p) {
  return chosenFresnel(p, fresnelTerm, edgeTint, p.values[normalReflectance].x);
}

auto arguments(const ParameterValues& p) {
  const double nx = p.values[exponentX].x, ny = p.values[exponentY].x, f0 = p.values[normalReflectance].x;
  const bool coupled = chosen(p.values[diffuseTerm].x) == 0;
  return std::tuple(p.values[diffuse] / pi * (coupled ? 28.0 / 23 * (1 - f0) : 1),
                    p.values[specular] * (std::sqrt((nx + 1) * (ny + 1)) / (8 * pi)), coupled ? 1.0 : 0.0,
                    glm::dvec2(nx, ny), grainAxis(p.values[rotation].x), fresnelOf(p));
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double nx = p.values[exponentX].x, ny = p.values[exponentY].x;
  return makeGeometryBrdf(
      bound<glsl::formula_ashikhmin_shirley, ranges::formula_ashikhmin_shirley>(arguments(p)),
      diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(p.values[specular]) * fresnelOf(p)(0.5),
                     RotatedDensity(HalfVectorDensity{CosinePowerNormals{nx, ny}}, p.values[rotation].x)),
      nx == ny);
}

/// cos^n theta_h is nearly exp(-n tan^2 theta_h / 2).
double widthOf(const ParameterValues& p, Index exponent) { return std::sqrt(2 / p.values[exponent].x); }

std::vector<ModelLobe> parts(const ParameterValues& p) {
  return diffuseAndHighlight(create, p, {widthOf(p, exponentX), widthOf(p, exponentY), p.values[rotation].x},
                             {p.values[normalReflectance], p.values[diffuseTerm]});
}

ParameterValues canonical(const ParameterValues& p) { return alongGrain(p, {exponentX, exponentY, rotation}, false); }

}  // namespace

const Model& ashikhminShirley() {
  static const Model model(
      ashikhminShirleySpec,
      {.create = create, .arguments = shaderArguments<arguments>, .lobes = parts, .canonical = canonical});
  return model;
}

}  // namespace gonio::models
