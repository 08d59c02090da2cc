// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/edit_energy.h"

#include "core/sampling/directional_albedo.h"

namespace gonio::editing {

namespace {

constexpr std::uint32_t sampleCount = 1 << 13;

Energy energyOf(const Brdf& brdf) {
  const SamplingDensity lobe = estimateSamplingDensity(brdf);
  return {luminance(directionalAlbedo(brdf, 0, lobe, sampleCount)),
          luminance(directionalAlbedo(brdf, grazingView, lobe, sampleCount))};
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

}  // namespace gonio::editing
