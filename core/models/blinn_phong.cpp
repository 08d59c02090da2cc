// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/cosine_power.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

namespace {

constexpr std::string_view blinn = "Blinn 1977, Models of Light Reflection for Computer Synthesized Pictures";
constexpr std::string_view normalisations[] = {"half-vector", "unit-albedo", "none"};

enum Index { diffuse, specular, exponent, normalisation };
enum Normalisation { halfVector, unitAlbedo, none };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    specularParameter(0.1, "k_s N cos^n theta_h", blinn),
    exponentParameter("cos^n theta_h", blinn),
    choiceParameter("normalisation", "Normalisation", "N",
                    "Scales the highlight with its sharpness so that its energy stays constant.",
                    "half-vector: (n + 2) / (8 pi); unit-albedo: (n + 2)(n + 4) / (8 pi (n + 2^(-n/2))); none: 1",
                    "Schüler 2011, The Blinn-Phong Normalization Zoo", normalisations),
};

constexpr ModelSpec blinnPhongSpec = {
    .id = "blinn-phong", .name = "Blinn-Phong",
    .description = "A cosine lobe about the half vector; simple and fast. Reciprocal; darkens towards grazing "
                   "angles. With the normalisation 'none' the albedo of the highlight depends on the exponent and "
                   "exceeds 1 for broad lobes.",
    .formula = "k_d / pi + k_s N cos^n theta_h", .reference = blinn, .parameters = parameters,
    .family = ModelFamily::empirical, .conservesEnergy = true};
// clang-format on

double normaliser(double n, int choice) {
  if (choice == halfVector) return (n + 2) / (8 * pi);
  if (choice == unitAlbedo) return halfVectorNormalisation(n);
  return 1;
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double n = p.values[exponent].x;
  const Rgb kd = p.values[diffuse] / pi;
  const Rgb ks = p.values[specular] * normaliser(n, chosen(p.values[normalisation].x));
  return makeGeometryBrdf([=](const SurfaceGeometry& g) { return kd + ks * halfVectorPower(g, n); },
                          diffuseMixture(maxChannel(p.values[diffuse]), maxChannel(p.values[specular]),
                                         HalfVectorDensity{CosinePowerNormals{n, n}}));
}

}  // namespace

const Model& blinnPhong() {
  static const Model model(blinnPhongSpec, {.create = create});
  return model;
}

}  // namespace gonio::models
