// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/anisotropic_parameters.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"
#include "core/models/ward_lobe.h"

namespace gonio::models {

namespace {

constexpr std::string_view ashikhmin2007 =
    "Ashikhmin and Premoze 2007, Distribution-Based BRDFs (Gaussian of slopes; its normalisation derived here)";

enum Index { diffuse, specular, roughnessX, roughnessY, normalReflectance, fresnelTerm, edgeTint, rotation };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(1, "k_s p(h) F / (cos theta_i + cos theta_o - cos theta_i cos theta_o)", ashikhmin2007),
    roughnessXParameter("p = exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / (4 pi alpha_x alpha_y)",
                        ashikhmin2007),
    roughnessYParameter("p = exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / (4 pi alpha_x alpha_y)",
                        ashikhmin2007),
    normalReflectanceParameter(),
    fresnelParameter(FresnelChoice::schlick),
    edgeTintParameter(),
    rotationParameter(),
};

constexpr ModelSpec ashikhminPremozeSpec = {
    .id = "ashikhmin-premoze", .name = "Ashikhmin-Premoze",
    .description = "Any distribution of half vectors, here a Gaussian of slopes, over a denominator that conserves "
                   "energy, so that no masking term is needed. Reciprocal; the albedo of the highlight never exceeds "
                   "k_s.",
    .formula = "k_d / pi + k_s p(h) F / (cos theta_i + cos theta_o - cos theta_i cos theta_o), "
               "p = exp(-(h_x^2 / alpha_x^2 + h_y^2 / alpha_y^2) / h_z^2) / (4 pi alpha_x alpha_y)",
    .reference = ashikhmin2007, .parameters = parameters,
    .family = ModelFamily::empirical, .conservesEnergy = true};
// clang-format on

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const Fresnel fresnel(FresnelChoice(chosen(p.values[fresnelTerm].x)), p.values[normalReflectance].x,
                        p.values[edgeTint].x);
  return makeWardBrdf(
      p.values[diffuse], p.values[specular], p.values[roughnessX].x, p.values[roughnessY].x, p.values[rotation].x,
      [fresnel](const SurfaceGeometry& g) { return fresnel(g.cosD) / (g.cosI + g.cosO - g.cosI * g.cosO); });
}

std::vector<glm::vec3> shaderParameters(const ParameterValues& p) { return withGrainAxis(p, rotation); }

ParameterValues canonical(const ParameterValues& p) { return alongGrain(p, {roughnessX, roughnessY, rotation}, true); }

}  // namespace

const Model& ashikhminPremoze() {
  static const Model model(ashikhminPremozeSpec,
                           {.create = create, .shaderParameters = shaderParameters, .canonical = canonical});
  return model;
}

}  // namespace gonio::models
