// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

#include "core/brdf/direction_sample.h"

namespace gonio {

/// A lobe (core/brdf/lobe_mixture.h) with density (n + 1) / (2 pi) max(0, a . w)^n about the axis a, which is scale *
/// wo normalised: the mirror direction in Phong 1975, "Illumination for Computer Generated Pictures", other scales in
/// Lafortune et al. 1997, "Non-Linear Approximation of Reflectance Functions". Accurate for exponents above 1e6.
struct CosinePowerLobe {
  double exponent;
  Direction scale{-1, -1, 1};

  Direction sample(const Direction& wo, const glm::dvec2& u) const {
    const Direction a = axis(wo);
    const double oneMinusCos = -std::expm1(std::log1p(-u.x) / (exponent + 1));
    const double sine = std::sqrt(oneMinusCos * (2 - oneMinusCos)), phi = 2 * pi * u.y;
    // An orthonormal basis about the axis without branches: Duff et al. 2017.
    const double sign = std::copysign(1.0, a.z), p = -1 / (sign + a.z), q = a.x * a.y * p;
    const Direction s(1 + sign * a.x * a.x * p, sign * q, -sign * a.x), t(q, sign + a.y * a.y * p, -a.y);
    return sine * std::cos(phi) * s + sine * std::sin(phi) * t + (1 - oneMinusCos) * a;
  }
  double density(const Direction& w, const Direction& wo) const {
    const Direction apart = w - axis(wo);
    const double oneMinusCos = glm::dot(apart, apart) / 2;
    if (!(oneMinusCos < 1)) return 0;
    return (exponent + 1) / (2 * pi) * std::exp(exponent * std::log1p(-oneMinusCos));
  }

 private:
  Direction axis(const Direction& wo) const {
    const Direction a = scale * wo;
    const double length = glm::length(a);
    return length > 0 ? a / length : Direction(0, 0, 1);
  }
};

}  // namespace gonio
