// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <limits>
#include <optional>

#include "core/interpolation/interpolation.h"

namespace gonio::interpolation {

/// A blend in the common form of its materials.
struct NativeFormBlend {
  std::shared_ptr<const Brdf> brdf;  ///< an RglBrdf or UtiaBrdf with IncidentDirection::viewer
  /// Index of the material with the same nodes as the result; 0 for UTIA files, which all have the same nodes.
  std::size_t nodesOf = 0;
  /// -20 log10 d, dB, where d is the mean over viewers of the light that |brdf - blend| would reflect under uniform
  /// illumination, as a fraction of the light that the blend reflects.
  double accuracy = std::numeric_limits<double>::infinity();
};

/// Minimum accuracy, dB, of blends of RGL files. A blend of a mirror-like and a wide highlight, for example, does not
/// reach it, because they need different nodes.
inline constexpr double minBlendAccuracy = 30;

/// For UTIA files a UTIA file, exact for linear blends. For RGL files (all isotropic, or all anisotropic) an RGL file
/// with the blend at the nodes of one of them, the one with the best accuracy. Empty if the interpolation does not mix
/// native forms (Interpolation::mixesNativeForms()), if a material has another form, or below minBlendAccuracy.
/// Materials of weight 0 are ignored. @throws Error for invalid weights; Cancelled.
std::optional<NativeFormBlend> nativeFormBlend(const Interpolation& interpolation, std::span<const double> weights,
                                               const TaskControl& control = {});

}  // namespace gonio::interpolation
