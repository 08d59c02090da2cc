// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <cmath>

#include "core/brdf/half_vector_lobe.h"
#include "core/brdf/tabulated_normals.h"
#include "core/models/common_parameters.h"
#include "core/models/fresnel.h"
#include "core/models/registry.h"
#include "core/models/v_cavity.h"

namespace gonio::models {

namespace {

constexpr std::string_view loew =
    "Loew, Kronander, Ynnerman and Unger 2012, BRDF Models for Accurate and Efficient Rendering of Glossy Surfaces";
constexpr std::string_view lobeFormula = "S = A / (1 + B (1 - cos theta_h))^C";
constexpr std::string_view normalisations[] = {"pi", "one"};

enum Index { diffuse, amplitude, narrowness, falloff, refractiveIndex, normalisation };

// clang-format off
// The hard ranges admit every published fit of the 100 MERL materials (A to 5710, B to 8.1e6, index to 100).
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    {.id = "a", .label = "Amplitude", .symbol = "A", .unit = "",
     .softMin = 0, .softMax = 1000, .hardMin = 0, .hardMax = 1e6, .defaultValue = 50,
     .perChannel = true, .linear = true,
     .description = "Strength and tint of the highlight, which is not normalised: raise it as the highlight narrows.",
     .formula = lobeFormula, .reference = loew},
    {.id = "b", .label = "Narrowness", .symbol = "B", .unit = "",
     .softMin = 10, .softMax = 1e6, .hardMin = 1e-3, .hardMax = 1e9, .defaultValue = 1000,
     .scale = ParameterScale::logarithmic,
     .description = "Where the falloff of the highlight begins: large is glossy.",
     .formula = lobeFormula, .reference = loew},
    {.id = "c", .label = "Falloff", .symbol = "C", .unit = "",
     .softMin = 0.1, .softMax = 3, .hardMin = 0, .hardMax = 20, .defaultValue = 1,
     .description = "How fast the highlight falls off beyond its core: small values leave a wide haze.",
     .formula = lobeFormula, .reference = loew},
    {.id = "index-of-refraction", .label = "Index of refraction", .symbol = "eta", .unit = "",
     .softMin = 1, .softMax = 5, .hardMin = 1, .hardMax = 1000, .defaultValue = 1.5,
     .scale = ParameterScale::logarithmic, .group = ParameterGroup::fresnel,
     .description = "How mirror-like the surface is when seen head-on; glass and plastics are near 1.5.",
     .formula = "F = F(cos theta_d, eta)", .reference = loew},
    choiceParameter("normalisation", "Normalisation", "N",
                    "The constant under the highlight: the published fits hold pi, the printed equation 1.",
                    "A ... / (N cos theta_i cos theta_o)", loew, normalisations),
};

constexpr ModelSpec abcSpec = {
    .id = "abc", .name = "ABC",
    .description = "Microfacets with the inverse-power distribution of polished surfaces (Church), V-cavity masking "
                   "and exact dielectric Fresnel. Reciprocal; the amplitude is free, so nothing bounds the energy.",
    .formula = "k_d / pi + S G F / (N cos theta_i cos theta_o), S = A / (1 + B (1 - cos theta_h))^C",
    .reference = loew, .parameters = parameters};
// clang-format on

class Abc final : public Model {
 public:
  const ModelSpec& spec() const override { return abcSpec; }

 protected:
  std::unique_ptr<const Brdf> create(const ParameterValues& p) const override {
    const double denominator = chosen(p.values[normalisation].x) == 0 ? pi : 1;
    const Rgb kd = p.values[diffuse] / pi, a = p.values[amplitude] / denominator;
    const double b = p.values[narrowness].x, c = p.values[falloff].x, eta = p.values[refractiveIndex].x;
    return makeGeometryBrdf(
        [=](const SurfaceGeometry& g) {
          const double lobe = std::exp(-c * std::log1p(b * g.oneMinusCosH));
          return kd + a * (lobe * fresnelDielectric(g.cosD, eta) * foldedVCavity(g));
        },
        diffuseAnd(maxChannel(p.values[diffuse]), maxChannel(a), HalfVectorLobe{TabulatedNormals([=](double thetaH) {
                     const double s = std::sin(thetaH / 2);
                     return std::exp(-c * std::log1p(2 * b * s * s));
                   })}));
  }
};

}  // namespace

const Model& abc() {
  static const Abc model;
  return model;
}

}  // namespace gonio::models
