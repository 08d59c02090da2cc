// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>

#include "core/models/abc_lobe.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"
#include "core/sampling/direction_densities.h"

namespace gonio::models {

namespace {

constexpr std::string_view lobeFormula = "S = A / (1 + B |i_p + o_p|^2)^C, i_p and o_p projected onto the surface";
constexpr std::string_view angles[] = {"exact", "projected"};

enum Index { diffuse, amplitude, narrowness, falloff, refractiveIndex, fresnelTerm, edgeTint, fresnelAngle };

// clang-format off
constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    abcAmplitudeParameter(lobeFormula),
    abcNarrownessParameter(lobeFormula),
    abcFalloffParameter(lobeFormula),
    refractiveIndexParameter(abcReference),
    fresnelParameter(FresnelChoice::dielectric),
    edgeTintParameter(),
    choiceParameter("fresnel-angle", "Fresnel angle", "theta_d",
                    "Angle of the Fresnel term: the published fits use that of the projected directions.",
                    "exact: cos theta_d = h . i; projected: cos theta_d = sqrt(1 - |i_p - o_p|^2 / 4)", abcReference,
                    angles),
};

constexpr ModelSpec abcSmoothSpec = {
    .id = "abc-smooth", .name = "ABC smooth",
    .description = "Scattering of polished surfaces (Rayleigh and Rice), radially symmetric about the mirror direction "
                   "on the disk of projected directions. Reciprocal; the amplitude is free, so nothing bounds the "
                   "energy.",
    .formula = "k_d / pi + S F, S = A / (1 + B |i_p + o_p|^2)^C", .reference = abcReference,
    .parameters = parameters};
// clang-format on

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const Rgb kd = p.values[diffuse] / pi, a = p.values[amplitude];
  const double b = p.values[narrowness].x, c = p.values[falloff].x;
  const double f0 = normalReflectanceFromIndex(p.values[refractiveIndex].x);
  const Fresnel fresnel = chosenFresnel(p, fresnelTerm, edgeTint, f0);
  const double tiltShare = chosen(p.values[fresnelAngle].x) == 0 ? 0 : 0.5;
  return makeGeometryBrdf(
      [=](const SurfaceGeometry& g) {
        const glm::dvec2 sum = glm::dvec2(g.wi) + glm::dvec2(g.wo);
        // 1 - |i_p - o_p|^2 / 4 is cos^2 theta_d and this; the difference would cancel toward grazing mirror pairs.
        const double tilt = tiltShare * (g.cosI - g.cosO),
                     cosD = std::min(1.0, std::sqrt(g.cosD * g.cosD + tilt * tilt));
        return kd + a * (abcLobe(glm::dot(sum, sum), b, c) * fresnel(cosD));
      },
      // The integral over the plane is pi times that over the squared radius.
      diffuseMixture(maxChannel(p.values[diffuse]), pi * maxChannel(a) * abcLobeIntegral(b, c) * fresnel(typicalCosine),
                     DiskDensity{RationalRadial{b, c}}));
}

}  // namespace

const Model& abcSmooth() {
  static const Model model(abcSmoothSpec, {.create = create});
  return model;
}

}  // namespace gonio::models
