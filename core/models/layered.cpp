// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>

#include "core/models/common_parameters.h"
#include "core/models/formula_range.h"
#include "core/models/registry.h"
#include "core/sampling/half_vector_densities.h"

/// A body, microfacet lobes that differ in width, and two lobes of fabrics and coatings: what a sum of simple lobes can
/// say of a measured material.
namespace gonio::models {

namespace glsl {
#include "core/models/layered.glsl"
}
namespace ranges {
#include "core/models/layered.glsl"
}

namespace {

constexpr std::string_view sources =
    "Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces, eq. 33; Heitz 2014, Understanding "
    "the Masking-Shadowing Function, eq. 99; Schlick 1994, An Inexpensive BRDF Model for "
    "Physically-based Rendering";
constexpr std::string_view lobeFormula =
    "(F_0 (1 - s) + F_90 s) D G / (4 cos theta_i cos theta_o), s = (1 - cos theta_d)^5";
constexpr std::string_view widthFormula = "D = alpha^2 / (pi (sin^2 theta_h + alpha^2 cos^2 theta_h)^2)";
constexpr std::string_view sheenSources =
    "Estévez and Kulla 2017, Production Friendly Microfacet Sheen BRDF, eq. 2; Neubelt and Pettineo 2013, Crafting a "
    "Next-Gen Material Pipeline for The Order: 1886";
constexpr std::string_view sheenFormula =
    "k_sh (2 + 1 / alpha) sin^(1 / alpha) theta_h / (8 pi (cos theta_i + cos theta_o - cos theta_i cos theta_o))";
constexpr std::string_view retroSources =
    "Guo, Guo and Pan 2018, A Retroreflective BRDF Model Based on Prismatic Sheeting and Microfacet Theory (the back "
    "vector in place of the half vector); Walter et al. 2007";
constexpr std::string_view retroFormula =
    "k_r D G / (4 cos theta_i cos theta_o), where h is the half vector of i and (-o_x, -o_y, o_z)";
constexpr std::string_view switches[] = {"off", "on"};

constexpr int lobeCount = 3;
/// In the order of the parameters: the widest first.
enum Lobe { base, flakes, coat };
/// Index of the first of the three parameters of a lobe.
constexpr std::size_t firstOf(int lobe) { return 1 + 3 * std::size_t(lobe); }
enum Index { sheen = 10, sheenRoughness, retro, retroRoughness, flakesSwitch, coatSwitch, sheenSwitch, retroSwitch };

// clang-format off
constexpr ParameterSpec reflectanceParameter(std::string_view id, std::string_view label, std::string_view symbol,
                                             double defaultValue, ParameterRole role, std::string_view description,
                                             std::string_view onlyWith = {}) {
  return {.id = id, .label = label, .symbol = symbol, .unit = "",
          .softMin = 0, .softMax = 1, .hardMin = 0, .hardMax = 100, .defaultValue = defaultValue,
          .perChannel = true, .linear = true,
          .description = description, .formula = lobeFormula, .reference = sources,
          .activeWith = onlyWith, .activeChoice = 1, .role = role};
}
constexpr ParameterSpec widthParameter(std::string_view id, std::string_view label, std::string_view symbol,
                                       double defaultValue, std::string_view description,
                                       std::string_view onlyWith = {}) {
  ParameterSpec spec = roughnessParameter(symbol, description, widthFormula, sources, 1, defaultValue);
  spec.id = id;
  spec.label = label;
  spec.activeWith = onlyWith;
  spec.activeChoice = 1;
  return spec;
}
constexpr ParameterSpec ofLobe(ParameterSpec spec, std::string_view formula, std::string_view reference) {
  spec.formula = formula;
  spec.reference = reference;
  spec.group = ParameterGroup::layer;
  return spec;
}
constexpr ParameterSpec switchParameter(std::string_view id, std::string_view label, std::string_view symbol, bool on,
                                        std::string_view description) {
  return choiceParameter(id, label, symbol, description,
                         "off: the lobe is black, and a fit does not change its parameters", sources,
                         switches, on ? 1 : 0);
}

constexpr ParameterSpec parameters[] = {
    diffuseParameter(0.2),
    reflectanceParameter("base", "Base", "F_0,1", 0.05, ParameterRole::highlight,
                         "Strength and colour of the widest lobe at normal incidence: the gloss of a matte surface."),
    reflectanceParameter("base-edge", "Base edge colour", "F_90,1", 0.05, ParameterRole::edge,
                         "Strength and colour of this lobe towards grazing angles."),
    widthParameter("base-roughness", "Base roughness", "alpha_1", 0.5, "Width of the widest lobe."),
    reflectanceParameter("flakes", "Flakes", "F_0,2", 0.05, ParameterRole::highlight,
                         "Strength and colour of the middle lobe at normal incidence: metal flakes, brushed metal.",
                         "flakes-lobe"),
    reflectanceParameter("flakes-edge", "Flake edge colour", "F_90,2", 0.05, ParameterRole::edge,
                         "Strength and colour of this lobe towards grazing angles.", "flakes-lobe"),
    widthParameter("flakes-roughness", "Flake roughness", "alpha_2", 0.2, "Width of the middle lobe.", "flakes-lobe"),
    reflectanceParameter("coat", "Coat", "F_0,3", 0.05, ParameterRole::coat,
                         "Strength and colour of the sharpest lobe at normal incidence: a clear coat, a polish.",
                         "coat-lobe"),
    reflectanceParameter("coat-edge", "Coat edge colour", "F_90,3", 0.5, ParameterRole::coatEdge,
                         "Strength and colour of this lobe towards grazing angles.", "coat-lobe"),
    widthParameter("coat-roughness", "Coat roughness", "alpha_3", 0.05, "Width of the sharpest lobe.", "coat-lobe"),
    ofLobe(reflectanceParameter("sheen", "Sheen", "k_sh", 0, ParameterRole::highlight,
                                "Strength and colour of the glow of fibres towards the edge.", "sheen-lobe"),
           sheenFormula, sheenSources),
    ofLobe(withRole(widthParameter("sheen-roughness", "Sheen roughness", "alpha_sh", 0.3,
                                   "Small values leave a thin rim, large ones cover the whole surface.", "sheen-lobe"),
                    ParameterRole::other),
           sheenFormula, sheenSources),
    ofLobe(reflectanceParameter("retro", "Retroreflection", "k_r", 0, ParameterRole::highlight,
                                "Strength and colour of the reflection back towards the light.",
                                "retro-lobe"),
           retroFormula, retroSources),
    ofLobe(widthParameter("retro-roughness", "Retroreflection roughness", "alpha_r", 0.3,
                          "Width of the lobe about the direction of the light.", "retro-lobe"),
           retroFormula, retroSources),
    switchParameter("flakes-lobe", "Flake lobe", "n_2", true,
                    "Adds the lobe of medium width, for metal flakes or brushed metal."),
    switchParameter("coat-lobe", "Coat lobe", "n_3", true, "Adds the sharpest lobe, for a clear coat or a polish."),
    switchParameter("sheen-lobe", "Sheen lobe", "n_sh", false,
                    "Adds the glow of fibres at the edge, for cloth."),
    switchParameter("retro-lobe", "Retroreflective lobe", "n_r", false,
                    "Adds reflection back towards the light, for road signs and safety fabric."),
};

constexpr ModelSpec layeredSpec = {
    .id = "layered", .name = "Layered lobes",
    .description = "A diffuse term and one to three GGX lobes from wide to sharp, each with separate colours at "
                   "normal and grazing incidence; a sheen and a retroreflective lobe where you switch them on. The "
                   "first fit adds the flake and coat lobes only if they clearly lower the error. Fits most measured "
                   "materials more closely than one lobe. Reciprocal; nothing bounds the energy.",
    .formula = "k_d / pi + the sum over the lobes of (F_0 (1 - s) + F_90 s) D G / (4 cos theta_i cos theta_o)",
    .reference = sources,
    .parameters = parameters};
// clang-format on

bool isOn(const ParameterValues& p, std::size_t choice) { return chosen(p.values[choice].x) == 1; }
bool isOn(const ParameterValues& p, Lobe lobe) {
  return lobe == base || isOn(p, lobe == flakes ? flakesSwitch : coatSwitch);
}

struct MicrofacetLobe {
  Rgb normal{0}, edge{0};
  double alpha2 = 1;

  Rgb operator()(const SurfaceGeometry& g) const { return glsl::layeredLobe(g, normal, edge, alpha2); }
  bool isBlack() const { return normal == Rgb(0) && edge == Rgb(0); }
};

Direction mirrored(const Direction& w) { return {-w.x, -w.y, w.z}; }

/// A lobe about the direction of the viewer in place of that about its mirror direction.
struct RetroLobe {
  VisibleNormalDensity lobe;
  Direction sample(const Direction& wo, const glm::dvec2& u) const { return lobe.sample(mirrored(wo), u); }
  double density(const Direction& w, const Direction& wo) const { return lobe.density(w, mirrored(wo)); }
};

MicrofacetLobe lobeOf(const ParameterValues& p, Lobe lobe) {
  const std::size_t first = firstOf(lobe);
  const double alpha = p.values[first + 2].x;
  if (!isOn(p, lobe)) return {Rgb(0), Rgb(0), alpha * alpha};
  return {p.values[first], p.values[first + 1], alpha * alpha};
}

/// About the albedo of the brightest channel.
double albedoOf(const MicrofacetLobe& lobe) { return maxChannel(0.9 * lobe.normal + 0.1 * lobe.edge); }

/// The parts of the sum; those that are off are black.
struct LayeredTerms {
  Rgb kd;
  std::array<MicrofacetLobe, lobeCount> lobes;
  Rgb glow{0};
  double exponent = 1;
  MicrofacetLobe back;

  explicit LayeredTerms(const ParameterValues& p)
      : kd(p.values[0] / pi),
        lobes{lobeOf(p, base), lobeOf(p, flakes), lobeOf(p, coat)},
        glow(isOn(p, sheenSwitch) ? p.values[sheen] : Rgb(0)),
        exponent(1 / p.values[sheenRoughness].x) {
    const Rgb backward = isOn(p, retroSwitch) ? p.values[retro] : Rgb(0);
    const double alpha = p.values[retroRoughness].x;
    back = {backward, backward, alpha * alpha};
  }
};

/// The bounds of the sum, part by part.
class LayeredBound final : public ValueBound {
 public:
  explicit LayeredBound(const LayeredTerms& terms) : terms_(terms) {}

  RgbRange over(const PairBox& box) const override {
    const ranges::SurfaceGeometry g(box);
    ranges::vec3 sum(terms_.kd);
    for (const MicrofacetLobe& lobe : terms_.lobes) sum = sum + rangeOf(lobe, g);
    if (!terms_.back.isBlack()) sum = sum + hulled(rangeOf(terms_.back, turned(box, g)));
    if (terms_.glow != Rgb(0)) sum = sum + sheenOver(g);
    return {Rgb(sum.x.low, sum.y.low, sum.z.low), Rgb(sum.x.high, sum.y.high, sum.z.high)};
  }

 private:
  static ranges::vec3 rangeOf(const MicrofacetLobe& lobe, const ranges::SurfaceGeometry& g) {
    if (lobe.isBlack()) return Rgb(0);
    ranges::vec3 value = ranges::layeredLobe(g, lobe.normal, lobe.edge, lobe.alpha2);
    // Both roots of the masking are at least alpha, and cos theta_i + cos theta_o = 2 cos theta_d cos theta_h, of which
    // the bounds of the single cosines do not know.
    const double slope = g.sin2H.low + lobe.alpha2 * g.h.z.low * g.h.z.low;
    const double most = lobe.alpha2 / (pi * slope * slope) * 0.25 / (std::sqrt(lobe.alpha2) * g.cosD.low * g.h.z.low);
    const Rgb brightest = glm::max(lobe.normal, lobe.edge);
    constexpr double rounding = 1e-9;
    value.x.high = std::min(value.x.high, most * brightest.x * (1 + rounding));
    value.y.high = std::min(value.y.high, most * brightest.y * (1 + rounding));
    value.z.high = std::min(value.z.high, most * brightest.z * (1 + rounding));
    return value;
  }
  /// With 0: wi = -wo, turned, has no half vector and does not reflect.
  static ranges::vec3 hulled(const ranges::vec3& v) { return {hull(0, v.x), hull(0, v.y), hull(0, v.z)}; }
  /// Of wi and the viewer turned by half a turn, wo': wi + wo' has the horizontal part of wi - wo.
  static ranges::SurfaceGeometry turned(const PairBox& box, const ranges::SurfaceGeometry& g) {
    ranges::SurfaceGeometry result = g;
    const auto fraction = [](const Range& x) { return ranges::clamp(x, 0, 1); };
    const Range cos2 = fraction(Range(1) + g.cosI * g.cosO - square(g.cosD));
    const Range across2 = max(Range(4) * (Range(1) - square(g.cosD)) - square(box.rise), 0);
    result.cosD = sqrt(cos2);
    result.sin2H = fraction(across2 / (Range(4) * cos2));
    result.h.z = sqrt(Range(1) - result.sin2H);
    return result;
  }
  ranges::vec3 sheenOver(const ranges::SurfaceGeometry& g) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    ranges::vec3 result{{infinity, -infinity}, {infinity, -infinity}, {infinity, -infinity}};
    overBranches([&] { return ranges::layeredSheen(g, terms_.glow, terms_.exponent); },
                 [&](const ranges::vec3& v) {
                   result = {hull(result.x, v.x), hull(result.y, v.y), hull(result.z, v.z)};
                 });
    return result;
  }

  LayeredTerms terms_;
};

/// A function of the geometry with the bounds of its values.
template <typename Evaluate>
auto withBound(const LayeredTerms& terms, Evaluate evaluate) {
  struct Bounded : Evaluate {
    LayeredTerms terms;
    std::shared_ptr<const ValueBound> valueBound() const { return std::make_shared<const LayeredBound>(terms); }
  };
  return Bounded{evaluate, terms};
}

std::unique_ptr<const Brdf> create(const ParameterValues& p) {
  const LayeredTerms terms(p);
  const auto& [kd, lobes, glow, exponent, back] = terms;
  const auto normals = [&](int lobe) { return VisibleNormalDensity{p.values[firstOf(lobe) + 2].x}; };
  // The glow of fibres is wide: cosine-weighted directions serve it.
  const std::array<double, 5> albedos{maxChannel(p.values[0]) + maxChannel(glow), albedoOf(lobes[base]),
                                      albedoOf(lobes[flakes]), albedoOf(lobes[coat]), albedoOf(back)};
  const DensityMixture<CosineDensity, VisibleNormalDensity, VisibleNormalDensity, VisibleNormalDensity, RetroLobe>
      sampler(mixtureFractions(albedos), CosineDensity{}, normals(base), normals(flakes), normals(coat),
              RetroLobe{VisibleNormalDensity{p.values[retroRoughness].x}});
  const auto highlights = [kd = kd, lobes = lobes](const SurfaceGeometry& g) {
    return kd + lobes[base](g) + lobes[flakes](g) + lobes[coat](g);
  };
  if (glow == Rgb(0) && back.isBlack()) return makeGeometryBrdf(withBound(terms, highlights), sampler);
  return makeGeometryBrdf(
      withBound(terms,
                [highlights, glow = glow, exponent = exponent, back = back](const SurfaceGeometry& g) {
                  const DirectionPair turned{g.wi, mirrored(g.wo)};
                  const Rgb retroreflected = isAboveSurface(turned) ? back(surfaceGeometry(turned)) : Rgb(0);
                  return highlights(g) + glsl::layeredSheen(g, glow, exponent) + retroreflected;
                }),
      sampler);
}

auto lobeArguments(const ParameterValues& p, Lobe lobe) {
  const MicrofacetLobe made = lobeOf(p, lobe);
  return std::tuple(made.normal, made.edge, made.alpha2);
}

auto arguments(const ParameterValues& p) {
  const double alphaR = p.values[retroRoughness].x;
  return std::tuple_cat(std::tuple(p.values[0] / pi), lobeArguments(p, base), lobeArguments(p, flakes),
                        lobeArguments(p, coat),
                        std::tuple(p.values[sheen], 1 / p.values[sheenRoughness].x, p.values[retro], alphaR * alphaR,
                                   isOn(p, sheenSwitch) ? 1.0 : 0.0, isOn(p, retroSwitch) ? 1.0 : 0.0));
}

/// The parts of the sum: the body, the lobes from wide to sharp, the sheen, the retroreflection.
constexpr int partCount = 1 + lobeCount + 2;

bool isPartOn(const ParameterValues& p, int part) {
  if (part == 0) return true;
  return part <= lobeCount ? isOn(p, Lobe(part - 1)) : isOn(p, part == lobeCount + 1 ? sheenSwitch : retroSwitch);
}

/// The parameters of a part; strengths that are set to 0 make it black.
std::vector<std::size_t> parametersOf(int part) {
  if (part == 0) return {0};
  if (part <= lobeCount) return {firstOf(part - 1), firstOf(part - 1) + 1, firstOf(part - 1) + 2};
  return part == lobeCount + 1 ? std::vector<std::size_t>{sheen, sheenRoughness}
                               : std::vector<std::size_t>{retro, retroRoughness};
}

/// Each part alone, by the same formula with all others black. Only the microfacet lobes have a highlight that moves
/// with the half vector.
std::vector<ModelLobe> parts(const ParameterValues& p) {
  std::vector<ModelLobe> result;
  for (int part = 0; part < partCount; ++part) {
    ParameterValues alone = p;
    for (int other = 0; other < partCount; ++other)
      for (const std::size_t i : parametersOf(other))
        if (other != part && parameters[i].linear) alone.values[i] = Rgb(0);
    const bool isMicrofacet = part > 0 && part <= lobeCount;
    const double alpha = isMicrofacet ? p.values[firstOf(part - 1) + 2].x : 0;
    ModelLobe one{create(alone), {alpha, alpha}, {}, {}};
    for (const std::size_t i : parametersOf(part)) {
      if (parameters[i].perChannel)
        one.colours.push_back(isPartOn(p, part) ? p.values[i] : Rgb(0));
      else
        one.parameters.push_back(p.values[i]);
    }
    result.push_back(std::move(one));
  }
  return result;
}

/// The lobes that are on from wide to sharp.
ParameterValues ordered(const ParameterValues& p) {
  std::vector<Lobe> places;
  for (const Lobe lobe : {base, flakes, coat})
    if (isOn(p, lobe)) places.push_back(lobe);
  std::vector<Lobe> order = places;
  std::ranges::stable_sort(order, std::greater{}, [&](Lobe lobe) { return p.values[firstOf(lobe) + 2].x; });
  ParameterValues result = p;
  for (std::size_t k = 0; k < places.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) result.values[firstOf(places[k]) + i] = p.values[firstOf(order[k]) + i];
  return result;
}

}  // namespace

const Model& layered() {
  static const Model model(
      layeredSpec, {.create = create, .arguments = shaderArguments<arguments>, .lobes = parts, .canonical = ordered});
  return model;
}

}  // namespace gonio::models
