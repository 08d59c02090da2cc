// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/srgb.h"

#include <algorithm>
#include <cmath>

namespace gonio {

double toSrgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double fromSrgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

Rgb displayed(const Rgb& radiance) {
  const auto clamped = [](double x) { return x > 0 ? std::min(x, 1.0) : 0.0; };
  return {clamped(radiance.x), clamped(radiance.y), clamped(radiance.z)};
}

}  // namespace gonio
