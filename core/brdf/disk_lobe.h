// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>

#include "core/brdf/direction_sample.h"

namespace gonio {

/// A lobe (core/brdf/lobe_mixture.h) on the unit disk of projected directions, rotationally symmetric about the mirror
/// direction of the viewer: for models of the projected deviation Dp = wi_xy + wo_xy. `Radial` is a density in the
/// plane:
///   double sample(double u) const; // |Dp|
///   double density(double r) const; // per unit area; 0 beyond diskReach, integrates to 1
/// Points outside the disk are moved inside by inversion in the unit circle (x becomes x / |x|^2), so that the density
/// integrates to 1: d omega cos theta = dx dy, and inversion scales areas by |x|^-4.
template <typename Radial>
struct DiskLobe {
  Radial radial;

  Direction sample(const Direction& wo, const glm::dvec2& u) const {
    const double r = radial.sample(u.x), phi = 2 * pi * u.y;
    glm::dvec2 x(r * std::cos(phi) - wo.x, r * std::sin(phi) - wo.y);
    const double squared = glm::dot(x, x);
    if (squared > 1) x /= squared;
    return {x.x, x.y, std::sqrt(std::max(0.0, 1 - glm::dot(x, x)))};
  }
  double density(const Direction& w, const Direction& wo) const {
    if (!(w.z > 0)) return 0;
    const glm::dvec2 x(w), viewer(wo);
    const double squared = glm::dot(x, x);
    double sum = radial.density(glm::length(x + viewer));
    // |Dp| <= 2 reaches points up to 3 from the origin: their inverses are at least 1/3 from it.
    if (squared > 1.0 / 9 - 1e-9) sum += radial.density(glm::length(x / squared + viewer)) / (squared * squared);
    return w.z * sum;
  }
};
template <typename Radial>
DiskLobe(Radial) -> DiskLobe<Radial>;

/// The largest distance between two points of the unit disk: the radial densities end there.
inline constexpr double diskReach = 2;

/// Proportional to exp(-r^2 / s^2) for r <= diskReach, s = `width`.
struct GaussianRadial {
  double width;

  double sample(double u) const { return width * std::sqrt(-std::log1p(-u * mass())); }
  double density(double r) const {
    return r > diskReach ? 0 : std::exp(-r * r / (width * width)) / (pi * width * width * mass());
  }

 private:
  double mass() const { return -std::expm1(-diskReach * diskReach / (width * width)); }
};

/// Proportional to (1 + B r^2)^-C for r <= diskReach, C >= 0: the ABC distribution (Löw et al. 2012, "BRDF Models for
/// Accurate and Efficient Rendering of Glossy Surfaces").
struct RationalRadial {
  double b, c;

  double sample(double u) const {
    const double end = std::log1p(b * diskReach * diskReach), e = 1 - c;
    // The integral of (1 + B x)^-C over x = r^2 is expm1(e ln(1 + B x)) / (e B).
    const double logarithm = std::abs(e) * end < 1e-9 ? u * end : std::log1p(u * std::expm1(e * end)) / e;
    return std::min(diskReach, std::sqrt(std::max(0.0, std::expm1(logarithm)) / b));
  }
  double density(double r) const {
    if (r > diskReach) return 0;
    const double end = std::log1p(b * diskReach * diskReach), e = 1 - c;
    const double area = std::abs(e) * end < 1e-9 ? end / b : std::expm1(e * end) / (e * b);
    return std::exp(-c * std::log1p(b * r * r)) / (pi * area);
  }
};

}  // namespace gonio
