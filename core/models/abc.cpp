// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/models/abc_lobe.h"
#include "core/models/registry.h"
#include "core/models/v_cavity.h"
#include "core/sampling/half_vector_densities.h"

namespace gonio::models {

namespace {

constexpr std::string_view lobeFormula = "S = A / (1 + B (1 - cos theta_h))^C";
constexpr std::string_view normalisations[] = {"pi", "one"};

enum Index { diffuse, amplitude, narrowness, falloff, refractiveIndex, normalisation, fresnelTerm, edgeTint };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    abcAmplitudeParameter(lobeFormula),
    abcNarrownessParameter(lobeFormula),
    abcFalloffParameter(lobeFormula),
    refractiveIndexParameter(abcReference),
    choiceParameter("normalisation", "Normalisation", "N",
                    "Constant N in the denominator of the highlight: pi in the published fits, 1 in the printed "
                    "equation.",
                    "A ... / (N cos theta_i cos theta_o)", abcReference, normalisations),
    fresnelParameter(FresnelChoice::dielectric),
    edgeTintParameter(),
};

constexpr ModelSpec abcSpec = {
    .id = "abc", .name = "ABC microfacet",
    .description = "Microfacets with the inverse-power distribution of polished surfaces (Church), V-cavity masking. "
                   "Reciprocal; the amplitude is free, so nothing bounds the energy.",
    .formula = "k_d / pi + S G F / (N cos theta_i cos theta_o), S = A / (1 + B (1 - cos theta_h))^C",
    .reference = abcReference, .parameters = parameters};
// clang-format on

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const double denominator = chosen(p.values[normalisation].x) == 0 ? pi : 1;
  const Rgb kd = p.values[diffuse] / pi, a = p.values[amplitude] / denominator;
  const double b = p.values[narrowness].x, c = p.values[falloff].x;
  const double f0 = normalReflectanceFromIndex(p.values[refractiveIndex].x);
  const Fresnel fresnel = chosenFresnel(p, fresnelTerm, edgeTint, f0);
  const double albedo = 8 * pi * maxChannel(a) * abcLobeIntegral(b, c) * fresnel(typicalCosine);
  return makeGeometryBrdf(
      [=](const SurfaceGeometry& g) {
        return kd + a * (abcLobe(g.oneMinusCosH, b, c) * fresnel(g.cosD) * vCavityOverCosines(g));
      },
      diffuseMixture(maxChannel(p.values[diffuse]), albedo, HalfVectorDensity{TabulatedNormals([=](double thetaH) {
                       const double s = std::sin(thetaH / 2);
                       return abcLobe(2 * s * s, b, c);
                     })}));
}

}  // namespace

const Model& abc() {
  static const Model model(abcSpec, {.create = create});
  return model;
}

}  // namespace gonio::models
