// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/rendering/environment.h"

namespace gonio {

/// Size of a blurred environment in pixels: 2.8 degrees per pixel.
inline constexpr int blurredWidth = 128, blurredHeight = 64;
/// Concentration of the blur kernel, a von Mises-Fisher distribution proportional to exp(concentration cos angle): 1 /
/// variance, for a standard deviation of 6 degrees along each tangent.
inline constexpr double blurConcentration = 91.2;

/// The environment as a background out of focus, which does not illuminate objects: its radiance convolved on the
/// sphere with the kernel above, cut off at 20 degrees. Constants are preserved. Computed once in the lifetime of the
/// environment (about 0.1 s); callable from several threads. @param environment not null.
std::shared_ptr<const EnvironmentMap> blurredEnvironment(const std::shared_ptr<const EnvironmentMap>& environment);

}  // namespace gonio
