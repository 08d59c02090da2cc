// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/interpolation/native_form_blend.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/utia_brdf.h"
#include "core/rgl/rgl_edit.h"
#include "core/sampling/fitted_densities.h"

namespace gonio::interpolation {

namespace {

const UtiaBrdf* utiaOf(const InterpolationMaterial& end) { return formOf<UtiaBrdf>(*end.base); }

std::shared_ptr<const Brdf> utiaBlend(const Brdf& blend, const TaskControl& control) {
  constexpr std::size_t side = UtiaBrdf::directionCount;
  std::vector<glm::vec3> values;
  values.reserve(side * side);
  std::vector<Rgb> row(side);
  for (std::size_t incident = 0; incident < side; ++incident) {
    control.throwIfStopped();
    blend.evaluate(UtiaBrdf::nodes(incident), row);
    values.insert(values.end(), row.begin(), row.end());
  }
  return std::make_shared<const UtiaBrdf>(std::move(values));
}

std::shared_ptr<const RglBrdf> rglBlend(const RglBrdf& nodes, const Brdf& blend, const TaskControl& control) {
  const auto file = nodes.withIncident(IncidentDirection::viewer);
  rgl::EditedRgl colours = rgl::editedColours(*file, blend, control);
  SliceStack<float> luminance = rgl::samplingLuminance(colours.rgb);
  return file->withColours(std::move(colours.rgb), std::move(luminance));
}

/// The accuracy in dB: -20 log10 of the albedo of the absolute difference over the albedo of the blend, which is the
/// mean over the viewers.
double accuracyOf(const Brdf& brdf, const std::vector<MomentProbe>& probes, const Brdf& blend) {
  double ratio = 0;
  int viewers = 0;
  for (std::size_t i = 0; i < probes.size(); ++viewers) {
    double error = 0, whole = 0;
    for (const Direction wo = probes[i].pair.wo; i < probes.size() && probes[i].pair.wo == wo; ++i) {
      const Direction& wi = probes[i].pair.wi;
      const Rgb truth = blend.evaluate(wi, wo), difference = glm::abs(brdf.evaluate(wi, wo) - truth);
      const double reflected = truth.x + truth.y + truth.z, weight = probes[i].energy / (reflected * reflected * wi.z);
      error += weight * (difference.x + difference.y + difference.z);
      whole += weight * reflected;
    }
    ratio += error / whole;
  }
  return ratio > 0 ? -20 * std::log10(ratio / viewers) : std::numeric_limits<double>::infinity();
}

NativeFormBlend bestRglBlend(std::span<const InterpolationMaterial> ends, std::span<const double> weights,
                             const Brdf& blend, const TaskControl& control) {
  const std::vector<MomentProbe> probes = momentProbes(blend);
  NativeFormBlend best{.accuracy = -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    std::shared_ptr<const RglBrdf> candidate = rglBlend(*formOf<RglBrdf>(*ends[i].base), blend, control);
    if (const double found = accuracyOf(*candidate, probes, blend); !best.brdf || found > best.accuracy)
      best = {std::move(candidate), i, found};
  }
  return best;
}

/// Whether a condition is true of all materials that have a weight.
template <typename Condition>
bool all(std::span<const InterpolationMaterial> ends, std::span<const double> weights, const Condition& condition) {
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (weights[i] > 0 && !(ends[i].base && condition(ends[i]))) return false;
  return true;
}

}  // namespace

std::optional<NativeFormBlend> nativeFormBlend(const Interpolation& interpolation, std::span<const double> weights,
                                               const TaskControl& control) {
  const std::shared_ptr<const Brdf> blend = interpolation.brdf(weights);
  if (!interpolation.mixesNativeForms()) return std::nullopt;
  const std::vector<InterpolationMaterial>& ends = interpolation.ends();
  if (all(ends, weights, utiaOf)) return NativeFormBlend{utiaBlend(*blend, control)};
  const auto isRgl = [&](const InterpolationMaterial& end) {
    return formOf<RglBrdf>(*end.base) && end.base->isIsotropic() == blend->isIsotropic();
  };
  if (!all(ends, weights, isRgl)) return std::nullopt;
  NativeFormBlend best = bestRglBlend(ends, weights, *blend, control);
  if (best.accuracy < minBlendAccuracy) return std::nullopt;
  return best;
}

}  // namespace gonio::interpolation
