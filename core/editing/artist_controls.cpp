// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/artist_controls.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/models/common_parameters.h"
#include "core/models/fresnel.h"

namespace gonio::editing {

namespace {

using models::ModelSpec;
using models::ParameterRole;
using models::ParameterScale;
using models::ParameterSpec;
using models::ParameterValues;

/// Beyond it nothing gets visibly stronger.
constexpr double strongest = 1000;
/// F_0 of a clear coat that is added to a material (index of refraction 1.5); its edge reflects everything.
constexpr double addedCoat = 0.04;

// clang-format off
constexpr ParameterSpec strengthControl(std::string_view id, std::string_view label, std::string_view symbol,
                                        std::string_view description, std::string_view formula) {
  return {.id = id, .label = label, .symbol = symbol, .unit = "",
          .softMin = 0, .softMax = 8, .hardMin = 0, .hardMax = strongest, .defaultValue = 1,
          .scale = ParameterScale::lightness, .description = description, .formula = formula};
}
constexpr ParameterSpec ratioControl(std::string_view id, std::string_view label, std::string_view symbol,
                                     std::string_view description, std::string_view formula) {
  return {.id = id, .label = label, .symbol = symbol, .unit = "",
          .softMin = 0.125, .softMax = 8, .hardMin = 1e-3, .hardMax = 1e3, .defaultValue = 1,
          .scale = ParameterScale::logarithmic, .description = description, .formula = formula};
}

/// In the order of ArtistControl.
constexpr ParameterSpec controls[] = {
    ratioControl("roughness", "Roughness", "x",
                 "Widens or narrows every highlight by this factor: 2 is twice as wide. With the composition Lobes, "
                 "highlights keep their albedo.",
                 "alpha' = x alpha, n' = n / x^2"),
    strengthControl("specular-strength", "Specular strength", "x", "Brightens or dims every highlight by this factor.",
                    "k_s' = x k_s"),
    {.id = "tint", .label = "Tint", .symbol = "t", .unit = "",
     .softMin = 0, .softMax = 1, .hardMin = 0, .hardMax = 10, .defaultValue = 1, .perChannel = true,
     .description = "Multiplies the colour of the whole material by this colour; white leaves it unchanged.",
     .formula = "rho' = t rho in each channel"},
    {.id = "saturation", .label = "Saturation", .symbol = "s", .unit = "",
     .softMin = 0, .softMax = 2, .hardMin = 0, .hardMax = 10, .defaultValue = 1,
     .description = "Scales the saturation of the whole material at constant luminance: 0 is grey, 1 leaves it "
                    "unchanged.",
     .formula = "rho' = max(0, Y + s (rho - Y)), Y the luminance of rho"},
    ratioControl("contrast", "Contrast", "x",
                 "Brightens the highlights and dims the diffuse term so that their ratio changes by this factor.",
                 "k_s' = k_s sqrt x, k_d' = k_d / sqrt x"),
    strengthControl("coat-strength", "Coat strength", "x",
                    "Multiplies the strength of the clear coat by this factor x: 0 removes the coat; above 1, x - 1 "
                    "times the reflectance of lacquer (0.04) is also added.",
                    "F_0' = x F_0 + 0.04 max(0, x - 1)"),
    strengthControl("edge-brightness", "Edge brightness", "x",
                    "Brightens or dims the highlights towards grazing angles by this factor; at normal "
                    "incidence nothing changes.",
                    "F_90' = x F_90"),
};

constexpr ModelSpec controlsSpec = {.id = "artist-controls", .name = "Controls",
                                    .description = "Controls for the visible appearance, with the same meaning for "
                                                   "every model.",
                                    .parameters = controls};
// clang-format on

bool isHighlight(ParameterRole role) { return role == ParameterRole::highlight || role == ParameterRole::peak; }
bool isCoat(ParameterRole role) { return role == ParameterRole::coat || role == ParameterRole::coatEdge; }
bool isEdge(ParameterRole role) { return role == ParameterRole::edge || role == ParameterRole::coatEdge; }
/// Whether a parameter belongs to the highlights, including edges and coats.
bool isSpecular(ParameterRole role) { return isHighlight(role) || isCoat(role) || role == ParameterRole::edge; }
bool isReflectance(ParameterRole role) {
  return role == ParameterRole::normalReflectance || role == ParameterRole::refractiveIndex;
}

/// The parameters of a model while controls change them.
struct Controlled {
  const ModelSpec& model;
  ParameterValues& p;

  template <class Role, class Change>
  void change(const Role& role, const Change& change) const {
    for (std::size_t i = 0; i < p.values.size(); ++i)
      if (role(model.parameters[i].role)) p.values[i] = change(p.values[i]);
  }
};

void widen(const Controlled& c, double x) {
  for (std::size_t i = 0; i < c.p.values.size(); ++i) switch (c.model.parameters[i].role) {
      case ParameterRole::width:
        c.p.values[i] *= x;
        break;
      case ParameterRole::sharpness:
      case ParameterRole::peak:
        c.p.values[i] /= x * x;
        break;
      default:
        break;
    }
}

/// The choice that a parameter matters with; none where it always does.
std::optional<std::size_t> switchOf(const ModelSpec& model, std::size_t parameter) {
  const std::string_view choice = model.parameters[parameter].activeWith;
  return choice.empty() ? std::nullopt : model.find(choice);
}
bool isActive(const ModelSpec& model, const ParameterValues& p, std::size_t parameter) {
  const auto choice = switchOf(model, parameter);
  return !choice || models::chosen(p.values[*choice].x) == model.parameters[parameter].activeChoice;
}

/// A coat that is added is switched on, where the fit had none.
void coat(const Controlled& c, double x) {
  const double added = std::max(0.0, x - 1);
  for (std::size_t i = 0; i < c.p.values.size(); ++i)
    if (added > 0 && c.model.parameters[i].role == ParameterRole::coat)
      if (const auto choice = switchOf(c.model, i)) c.p.values[*choice] = Rgb(c.model.parameters[i].activeChoice);
  c.change([](ParameterRole role) { return role == ParameterRole::coat; },
           [=](const Rgb& k) { return x * k + addedCoat * added; });
  c.change([](ParameterRole role) { return role == ParameterRole::coatEdge; },
           [=](const Rgb& k) { return x * k + added; });
}

double reflectanceOf(const ParameterSpec& spec, double value) {
  return spec.role == ParameterRole::refractiveIndex ? models::normalReflectanceFromIndex(value) : value;
}
double valueOf(const ParameterSpec& spec, double f0) {
  const double value = spec.role == ParameterRole::refractiveIndex ? models::indexFromNormalReflectance(f0) : f0;
  return std::clamp(value, spec.hardMin, spec.hardMax);
}

/// The edge of a lobe k F(F_0) is k, head-on it is k F_0: k grows while F_0 falls. Where F_0 would be above 1 the edge
/// gets as dark as the highlight head-on.
void brightenEdge(const Controlled& c, double x) {
  c.change(isEdge, [x](const Rgb& k) { return x * k; });
  std::size_t strength = c.p.values.size();
  for (std::size_t i = 0; i < c.p.values.size(); ++i) {
    const ParameterSpec& spec = c.model.parameters[i];
    if (isHighlight(spec.role) || spec.role == ParameterRole::coat) strength = i;
    if (!isReflectance(spec.role) || strength == c.p.values.size()) continue;
    const double before = reflectanceOf(spec, c.p.values[i].x);
    if (before <= 0) {
      c.p.values[strength] *= x;
      continue;
    }
    const double value = valueOf(spec, std::min(1.0, x > 0 ? before / x : 1.0));
    const double after = reflectanceOf(spec, value);
    c.p.values[i] = Rgb(value);
    if (after > 0) c.p.values[strength] *= before / after;
  }
}

void apply(ArtistControl control, const Rgb& value, const Controlled& c) {
  const double x = value.x;
  switch (control) {
    case ArtistControl::roughness:
      return widen(c, x);
    case ArtistControl::specularStrength:
      return c.change(isSpecular, [x](const Rgb& k) { return x * k; });
    case ArtistControl::tint:
    case ArtistControl::saturation:
      return;
    case ArtistControl::contrast:
      c.change(isSpecular, [root = std::sqrt(x)](const Rgb& k) { return k * root; });
      return c.change([](ParameterRole role) { return role == ParameterRole::diffuse; },
                      [root = std::sqrt(x)](const Rgb& k) { return k / root; });
    case ArtistControl::coatStrength:
      return coat(c, x);
    case ArtistControl::edgeBrightness:
      return brightenEdge(c, x);
  }
}

bool isNeutral(const ParameterValues& values, std::size_t control) {
  return values.values[control] == Rgb(controls[control].defaultValue);
}

/// The first `count` controls applied.
ParameterValues withFirst(std::size_t count, const ModelSpec& model, ParameterValues parameters,
                          const ParameterValues& values) {
  bool changed = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (isNeutral(values, i) || actsOnValues(ArtistControl(i)) || !actsOn(ArtistControl(i), model)) continue;
    apply(ArtistControl(i), values.values[i], {model, parameters});
    changed = true;
  }
  if (changed) models::clampToHardRange(model, parameters);
  return parameters;
}

}  // namespace

const ModelSpec& artistControls() { return controlsSpec; }

bool actsOnValues(ArtistControl control) {
  return control == ArtistControl::tint || control == ArtistControl::saturation;
}

glm::dmat3 colourMatrix(const ParameterValues& values) {
  glm::dmat3 matrix(1);
  const auto tint = std::size_t(ArtistControl::tint), saturation = std::size_t(ArtistControl::saturation);
  if (isNeutral(values, tint) && isNeutral(values, saturation)) return matrix;
  for (int channel = 0; channel < 3; ++channel) {
    const Rgb tinted = matrix[channel] * values.values[tint][channel];
    matrix[channel] = luminance(tinted) + values.values[saturation].x * (tinted - luminance(tinted));
  }
  return matrix;
}

bool actsOn(ArtistControl control, const ModelSpec& model) {
  const auto has = [&](const auto& wanted) {
    return std::ranges::any_of(model.parameters, [&](const ParameterSpec& spec) { return wanted(spec.role); });
  };
  const auto isDiffuse = [](ParameterRole role) { return role == ParameterRole::diffuse; };
  switch (control) {
    case ArtistControl::roughness:
      return has([](ParameterRole role) { return role == ParameterRole::width || role == ParameterRole::sharpness; });
    case ArtistControl::specularStrength:
      return has(isSpecular);
    case ArtistControl::tint:
    case ArtistControl::saturation:
      return true;
    case ArtistControl::contrast:
      return has(isDiffuse) && has(isSpecular);
    case ArtistControl::coatStrength:
      return has(isCoat);
    case ArtistControl::edgeBrightness:
      return has(isEdge) || has(isReflectance);
  }
  return false;
}

ParameterValues withControls(const ModelSpec& model, ParameterValues parameters, const ParameterValues& values) {
  return withFirst(std::size(controls), model, std::move(parameters), values);
}

ParameterValues withWidthsOf(const ParameterValues& fitted, const ModelSpec& model, ParameterValues parameters,
                             ParameterValues values) {
  const auto roughness = std::size_t(ArtistControl::roughness);
  values.values[roughness] = Rgb(controls[roughness].defaultValue);
  for (std::size_t i = 0; i < parameters.values.size(); ++i) {
    const ParameterRole role = model.parameters[i].role;
    if (role == ParameterRole::width || role == ParameterRole::sharpness) parameters.values[i] = fitted.values[i];
  }
  return withControls(model, std::move(parameters), values);
}

std::vector<ControlledParameter> changesBy(ArtistControl control, const ModelSpec& model,
                                           const ParameterValues& parameters, const ParameterValues& values) {
  const ParameterValues before = withFirst(std::size_t(control), model, parameters, values);
  const ParameterValues after = withFirst(std::size_t(control) + 1, model, parameters, values);
  std::vector<ControlledParameter> changes;
  for (std::size_t i = 0; i < before.values.size(); ++i)
    if (before.values[i] != after.values[i] && isActive(model, after, i))
      changes.push_back({i, before.values[i], after.values[i]});
  return changes;
}

}  // namespace gonio::editing
