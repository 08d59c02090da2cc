// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>

#include "core/math/fast_functions.h"
#include "core/math/types.h"

/// Densities (core/brdf/density_mixture.h) that draw directions themselves, not the half vectors of
/// core/sampling/half_vector_densities.h.
namespace gonio {

/// (n + 1) / (2 pi) max(0, a . w)^n about the axis a, which is scale * wo normalised: the mirror direction in Phong
/// 1975, "Illumination for Computer Generated Pictures", other scales in Lafortune et al. 1997, "Non-Linear
/// Approximation of Reflectance Functions". Accurate for exponents above 1e6.
struct CosinePowerDensity {
  double exponent;
  Direction scale{-1, -1, 1};

  Direction sample(const Direction& wo, const glm::dvec2& u) const {
    const Direction a = axis(wo);
    const double oneMinusCos = -std::expm1(std::log1p(-u.x) / (exponent + 1));
    const double sine = std::sqrt(oneMinusCos * (2 - oneMinusCos));
    const auto turn = fastSineAndCosine(u.y);
    // An orthonormal basis about the axis without branches: Duff et al. 2017.
    const double sign = std::copysign(1.0, a.z), p = -1 / (sign + a.z), q = a.x * a.y * p;
    const Direction s(1 + sign * a.x * a.x * p, sign * q, -sign * a.x), t(q, sign + a.y * a.y * p, -a.y);
    return sine * turn.cosine * s + sine * turn.sine * t + (1 - oneMinusCos) * a;
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

/// A density on the unit disk of projected directions, rotationally symmetric about the mirror direction of the viewer:
/// for models of the projected deviation Dp = wi_xy + wo_xy. `Radial` is a density in the plane:
///   double sample(double u) const; // |Dp|
///   double density(double r) const; // per unit area; 0 beyond diskReach, integrates to 1
/// Points outside the disk are moved inside by inversion in the unit circle (x becomes x / |x|^2), so that the density
/// integrates to 1: d omega cos theta = dx dy, and inversion scales areas by |x|^-4.
template <typename Radial>
struct DiskDensity {
  Radial radial;

  Direction sample(const Direction& wo, const glm::dvec2& u) const {
    const double r = radial.sample(u.x);
    const auto turn = fastSineAndCosine(u.y);
    glm::dvec2 x(r * turn.cosine - wo.x, r * turn.sine - wo.y);
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
DiskDensity(Radial) -> DiskDensity<Radial>;

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

/// For a point of the unit disk: its distance from the viewer's mirror point -wo_xy, as a fraction of the distance to
/// the rim in the same direction, squared; 0 at the mirror point, 1 on the rim. @param deviation Dp = wi_xy + wo_xy of
/// the point.
inline double squaredRimFraction(const glm::dvec2& deviation, const Direction& wo) {
  // The rim lies at the distance d . wo_xy + sqrt((d . wo_xy)^2 + cos^2 theta_o) in the direction d of Dp.
  const double squared = glm::dot(deviation, deviation), along = glm::dot(deviation, glm::dvec2(wo));
  if (!(squared > 0)) return 0;
  const double root = std::sqrt(along * along + wo.z * wo.z * squared);
  // Uses the form without cancellation.
  const double fraction = along > 0 ? squared / (along + root) : (root - along) / (wo.z * wo.z);
  return std::min(1.0, fraction * fraction);
}

/// A density on the unit disk of projected directions: (n + 1) / pi (1 - u^2)^n with the fraction u of
/// squaredRimFraction(). It integrates to 1 for every viewer: a ray of length L from the mirror point contributes
/// L^2 / (2 pi) per radian, and the integral of L^2 over all rays is twice the area of the disk.
struct RimPowerDensity {
  double exponent;

  Direction sample(const Direction& wo, const glm::dvec2& u) const {
    // A uniformly sampled point has the right azimuth and a uniform squared fraction; only the fraction is changed.
    const double r = std::sqrt(u.x);
    const auto turn = fastSineAndCosine(u.y);
    glm::dvec2 deviation = r * glm::dvec2(turn.cosine, turn.sine) + glm::dvec2(wo);
    const double uniformFraction = squaredRimFraction(deviation, wo);
    if (uniformFraction > 0)
      deviation *= std::sqrt(-std::expm1(std::log1p(-uniformFraction) / (exponent + 1)) / uniformFraction);
    const glm::dvec2 x = deviation - glm::dvec2(wo);
    return {x.x, x.y, std::sqrt(std::max(0.0, 1 - glm::dot(x, x)))};
  }
  double density(const Direction& w, const Direction& wo) const {
    if (!(w.z > 0)) return 0;
    const double squared = squaredRimFraction(glm::dvec2(w) + glm::dvec2(wo), wo);
    return squared < 1 ? w.z * (exponent + 1) / pi * std::exp(exponent * std::log1p(-squared)) : 0;
  }
};

/// A density rotated about the normal.
template <typename Density>
class RotatedDensity {
 public:
  /// @param rotation angle of the density's x axis from the tangent, rad, counter-clockwise seen from above.
  RotatedDensity(Density density, double rotation) : density_(density), toGrain_(-rotation), fromGrain_(rotation) {}

  Direction sample(const Direction& wo, const glm::dvec2& u) const {
    return fromGrain_(density_.sample(toGrain_(wo), u));
  }
  double density(const Direction& w, const Direction& wo) const { return density_.density(toGrain_(w), toGrain_(wo)); }

 private:
  Density density_;
  AzimuthRotation toGrain_, fromGrain_;
};

}  // namespace gonio
