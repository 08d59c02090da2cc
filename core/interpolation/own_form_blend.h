// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <limits>
#include <optional>

#include "core/interpolation/interpolation.h"

namespace gonio::editing {

/// A blend in the form that all its materials have.
struct OwnFormBlend {
  std::shared_ptr<const Brdf>
      brdf;               ///< an RGL or UTIA file in memory, the viewer in the slot of the incident direction
  std::size_t nodes = 0;  ///< of which material; UTIA files share theirs
  /// dB: what its difference from the blend reflects of a uniform light, sign aside, over what the blend reflects.
  double accuracy = std::numeric_limits<double>::infinity();
};

/// Less accurate ones are not used: a highlight as narrow as a mirror's beside a wide one has no nodes in common.
inline constexpr double leastBlendAccuracy = 30;

/// Whether a space mixes materials in their own form: `linear` and `differential`.
bool mixesOwnForms(InterpolationSpace space);

/// Of UTIA files a UTIA file, of which linear blends are exact; of RGL files (all isotropic, or all anisotropic) an RGL
/// file that holds the blend at the nodes of one of them, that which follows it best. Nothing in spaces that do not mix
/// own forms, where a material has another form, and where no nodes follow the blend. @throws Error for weights that
/// are none; Cancelled.
std::optional<OwnFormBlend> ownFormBlend(const Interpolation& interpolation, InterpolationSpace space,
                                         std::span<const double> weights, const TaskControl& control = {});

}  // namespace gonio::editing
