// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>
#include <cmath>

#include "core/brdf/visible_normal_lobe.h"
#include "core/models/common_parameters.h"
#include "core/models/registry.h"
#include "core/models/surface_geometry.h"

/// A body and three microfacet lobes that differ in width: what a sum of simple lobes can say of a measured material.
namespace gonio::models {

namespace {

constexpr std::string_view sources =
    "Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces, eq. 33; Heitz 2014, Understanding "
    "the "
    "Masking-Shadowing Function, eq. 99; Schlick 1994";
constexpr std::string_view lobeFormula =
    "(F_0 (1 - s) + F_90 s) D G / (4 cos theta_i cos theta_o), s = (1 - cos theta_d)^5";

constexpr int lobeCount = 3;
/// In the order of the parameters: the widest first.
enum Lobe { base, flakes, coat };
/// Index of the first of the three parameters of a lobe.
constexpr std::size_t firstOf(int lobe) { return 1 + 3 * std::size_t(lobe); }

// clang-format off
constexpr ParameterSpec reflectanceParameter(std::string_view id, std::string_view label, std::string_view symbol,
                                             double defaultValue, ParameterRole role,
                                             std::string_view description) {
  return {.id = id, .label = label, .symbol = symbol, .unit = "",
          .softMin = 0, .softMax = 1, .hardMin = 0, .hardMax = 100, .defaultValue = defaultValue,
          .perChannel = true, .linear = true,
          .description = description, .formula = lobeFormula, .reference = sources, .role = role};
}
constexpr ParameterSpec widthParameter(std::string_view id, std::string_view label, std::string_view symbol,
                                       double defaultValue, std::string_view description) {
  ParameterSpec spec = roughnessParameter(symbol, description,
                                          "D = alpha^2 / (pi (sin^2 theta_h + alpha^2 cos^2 theta_h)^2)", sources, 1,
                                          defaultValue);
  spec.id = id;
  spec.label = label;
  return spec;
}

constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    reflectanceParameter("base", "Base", "F_0,1", 0.05, ParameterRole::highlight,
                         "Strength and colour of the widest lobe, seen head-on: the sheen of a matte surface."),
    reflectanceParameter("base-edge", "Base, edge", "F_90,1", 0.05, ParameterRole::edge, "The same toward grazing angles."),
    widthParameter("base-roughness", "Base, roughness", "alpha_1", 0.5, "Width of the widest lobe."),
    reflectanceParameter("flakes", "Flakes", "F_0,2", 0.05, ParameterRole::highlight,
                         "Strength and colour of the middle lobe, seen head-on: metal flakes, a brushed metal."),
    reflectanceParameter("flakes-edge", "Flakes, edge", "F_90,2", 0.05, ParameterRole::edge, "The same toward grazing angles."),
    widthParameter("flakes-roughness", "Flakes, roughness", "alpha_2", 0.2, "Width of the middle lobe."),
    reflectanceParameter("coat", "Coat", "F_0,3", 0.05, ParameterRole::coat,
                         "Strength and colour of the sharpest lobe, seen head-on: a clear coat, a polish."),
    reflectanceParameter("coat-edge", "Coat, edge", "F_90,3", 0.5, ParameterRole::coatEdge, "The same toward grazing angles."),
    widthParameter("coat-roughness", "Coat, roughness", "alpha_3", 0.05, "Width of the sharpest lobe."),
};

constexpr ModelSpec layeredSpec = {
    .id = "layered", .name = "Layered lobes",
    .description = "A diffuse body and up to three GGX lobes from wide to sharp, each with a colour of its own head-on "
                   "and at the edge. Fits most measured materials closer than one lobe. Reciprocal; keeps to no "
                   "energy limit.",
    .formula = "k_d / pi + the sum over three lobes of (F_0 (1 - s) + F_90 s) D G / (4 cos theta_i cos theta_o)",
    .reference = sources,
    .parameters = parameters};
// clang-format on

struct MicrofacetLobe {
  Rgb normal{0}, edge{0};
  double alpha2 = 1;

  /// Height-correlated masking, folded so that nothing is divided by a cosine.
  Rgb operator()(const SurfaceGeometry& g) const {
    const double slope = g.sin2H + alpha2 * g.half.z * g.half.z;
    const double rootI = std::sqrt(alpha2 + (1 - alpha2) * g.cosI * g.cosI);
    const double rootO = std::sqrt(alpha2 + (1 - alpha2) * g.cosO * g.cosO);
    const double m = 1 - g.cosD, m2 = m * m, s = m2 * m2 * m;
    const double lobe = alpha2 / (pi * slope * slope) * 0.5 / (g.cosO * rootI + g.cosI * rootO);
    return lobe * ((1 - s) * normal + s * edge);
  }
  bool isBlack() const { return normal == Rgb(0) && edge == Rgb(0); }
};

MicrofacetLobe lobeOf(const ParameterValues& p, int lobe) {
  const std::size_t first = firstOf(lobe);
  const double alpha = p.values[first + 2].x;
  return {p.values[first], p.values[first + 1], alpha * alpha};
}

/// About the albedo of the brightest channel.
double albedoOf(const MicrofacetLobe& lobe) { return maxChannel(0.9 * lobe.normal + 0.1 * lobe.edge); }

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const Rgb kd = p.values[0] / pi;
  const std::array<MicrofacetLobe, lobeCount> lobes{lobeOf(p, base), lobeOf(p, flakes), lobeOf(p, coat)};
  const auto normals = [&](int lobe) { return VisibleNormalLobe{p.values[firstOf(lobe) + 2].x}; };
  const std::array<double, 4> albedos{maxChannel(p.values[0]), albedoOf(lobes[base]), albedoOf(lobes[flakes]),
                                      albedoOf(lobes[coat])};
  return makeGeometryBrdf(
      [=](const SurfaceGeometry& g) {
        Rgb value = kd;
        for (const MicrofacetLobe& lobe : lobes)
          if (!lobe.isBlack()) value += lobe(g);
        return value;
      },
      LobeMixture<CosineLobe, VisibleNormalLobe, VisibleNormalLobe, VisibleNormalLobe>(
          lobeShares(albedos), CosineLobe{}, normals(base), normals(flakes), normals(coat)));
}

/// The body and each lobe alone, by the same formula with all others black.
std::vector<ModelLobe> parts(const ParameterValues& p) {
  std::vector<ModelLobe> result;
  for (int part = -1; part < lobeCount; ++part) {
    ParameterValues alone = p;
    if (part >= 0) alone.values[0] = Rgb(0);
    for (int lobe = 0; lobe < lobeCount; ++lobe)
      if (lobe != part) alone.values[firstOf(lobe)] = alone.values[firstOf(lobe) + 1] = Rgb(0);
    if (part < 0) {
      result.push_back({create(alone), 0, {p.values[0]}});
      continue;
    }
    const auto own = p.values.begin() + std::ptrdiff_t(firstOf(part));
    result.push_back({create(alone), own[2].x, {own, own + 3}});
  }
  return result;
}

/// The lobes from wide to sharp.
ParameterValues ordered(const ParameterValues& p) {
  std::array<int, lobeCount> order{base, flakes, coat};
  std::ranges::stable_sort(order, std::greater{}, [&](int lobe) { return p.values[firstOf(lobe) + 2].x; });
  ParameterValues result = p;
  for (int to = 0; to < lobeCount; ++to)
    for (std::size_t i = 0; i < 3; ++i) result.values[firstOf(to) + i] = p.values[firstOf(order[std::size_t(to)]) + i];
  return result;
}

}  // namespace

const Model& layered() {
  static const Model model(layeredSpec, {.create = create, .lobes = parts, .canonical = ordered});
  return model;
}

}  // namespace gonio::models
