// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/edit_plausibility.h"

#include "core/sampling/directional_albedo.h"

namespace gonio::editing {

namespace {

constexpr std::uint32_t sampleCount = 1 << 13;

Energy energyOf(const Brdf& brdf) {
  const DirectionalAlbedo albedo(brdf, sampleCount);
  return {luminance(albedo(0)), luminance(albedo(grazingView))};
}

}  // namespace

std::vector<Energy> energiesThrough(const std::shared_ptr<const Brdf>& base, std::span<const Edit> edits,
                                    const TaskControl& control) {
  std::vector<Energy> energies{energyOf(*base)};
  for (std::size_t i = 0; i < edits.size(); ++i) {
    control.throwIfStopped();
    energies.push_back(edits[i].isIdentity() ? energies.back() : energyOf(*applyEdits(base, edits.first(i + 1))));
  }
  return energies;
}

std::vector<metrics::PlausibilityCheck> checkEditPlausibility(const std::shared_ptr<const Brdf>& base,
                                                              std::span<const Edit> edits, const TaskControl& control) {
  auto checks = metrics::checkPlausibility(*applyEdits(base, edits), control);
  control.throwIfStopped();
  std::vector<metrics::PlausibilityCheck> ordered;
  for (const char* name : {"energy", "reciprocity", "non-finite"})
    for (metrics::PlausibilityCheck& check : checks)
      if (check.name == name) ordered.push_back(std::move(check));
  ordered.insert(ordered.begin() + 2, metrics::checkNegative(*applyEditsUnclamped(base, edits), *base));
  if (const TabulatedBrdf* table = formOf<TabulatedBrdf>(*base)) ordered.push_back(metrics::checkCoverage(*table));
  return ordered;
}

}  // namespace gonio::editing
