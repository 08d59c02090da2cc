// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>

#include "core/models/anisotropic_parameters.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"
#include "core/sampling/direction_densities.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

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
    .family = ModelFamily::empirical, .conservesEnergy = true};
// clang-format on

double entering(double cosine) {
  const double m = 1 - cosine / 2, m2 = m * m;
  return 1 - m2 * m2 * m;
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double nx = p.values[exponentX].x, ny = p.values[exponentY].x, f0 = p.values[normalReflectance].x;
  const double coupled = chosen(p.values[diffuseTerm].x) == 0 ? 1 : 0;
  const Rgb kd = p.values[diffuse] / pi * (coupled == 1 ? 28.0 / 23 * (1 - f0) : 1);
  const Rgb ks = p.values[specular] * (std::sqrt((nx + 1) * (ny + 1)) / (8 * pi));
  const Fresnel fresnel(FresnelChoice(chosen(p.values[fresnelTerm].x)), f0, p.values[edgeTint].x);
  return makeGeometryBrdf(
      [=, toGrain = AzimuthRotation(-p.values[rotation].x)](const SurfaceGeometry& g) {
        const Direction half = toGrain(g.half);
        const double slopes = nx * half.x * half.x + ny * half.y * half.y;
        const double power = halfVectorPower(g, g.sin2H > 0 ? slopes / g.sin2H : 0);
        const double lobe = power * fresnel(g.cosD) / (g.cosD * std::max(g.cosI, g.cosO));
        return (coupled * (entering(g.cosI) * entering(g.cosO)) + (1 - coupled)) * kd + ks * lobe;
      },
      diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(p.values[specular]) * fresnel(0.5),
                     RotatedDensity(HalfVectorDensity{CosinePowerNormals{nx, ny}}, p.values[rotation].x)),
      nx == ny);
}

/// cos^n theta_h is nearly exp(-n tan^2 theta_h / 2).
double widthOf(const ParameterValues& p, Index exponent) { return std::sqrt(2 / p.values[exponent].x); }

std::vector<ModelLobe> parts(const ParameterValues& p) {
  return diffuseAndHighlight(create, p, {widthOf(p, exponentX), widthOf(p, exponentY), p.values[rotation].x},
                             {p.values[normalReflectance], p.values[diffuseTerm]});
}

std::vector<glm::vec3> shaderParameters(const ParameterValues& p) { return withGrainAxis(p, rotation); }

ParameterValues canonical(const ParameterValues& p) { return alongGrain(p, {exponentX, exponentY, rotation}, false); }

}  // namespace

const Model& ashikhminShirley() {
  static const Model model(
      ashikhminShirleySpec,
      {.create = create, .shaderParameters = shaderParameters, .lobes = parts, .canonical = canonical});
  return model;
}

}  // namespace gonio::models
