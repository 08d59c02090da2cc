// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/rendering/environment.h"

namespace gonio {

/// Size of a blurred environment's picture: 2.8 degrees per pixel.
inline constexpr int blurredWidth = 128, blurredHeight = 64;
/// Width of the blur: the concentration of a von Mises-Fisher distribution, exp(concentration cos angle) up to scale,
/// whose standard deviation is 6 degrees along either tangent (concentration = 1 / variance, rad).
inline constexpr double blurConcentration = 91.2;

/// The environment as it is shown behind objects when it is out of focus: its radiance convolved on the sphere with the
/// distribution above, cut off at 20 degrees. It lights nothing. A constant stays as it is. Computed once
/// while the environment lives, some 0.1 s; from any thread. @param environment not null.
std::shared_ptr<const EnvironmentMap> blurredEnvironment(const std::shared_ptr<const EnvironmentMap>& environment);

}  // namespace gonio
