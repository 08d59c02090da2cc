// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>

#include "core/brdf/brdf.h"

namespace gonio::rendering {

/// Upper bound A(F) of the radiance that a material reflects to a viewer from a light of radiance 1 that covers a
/// fraction F of the cosine-weighted hemisphere, at the position where the material reflects most:
///   A(F) = max over wo and over all regions W of the integral over W of f cos theta_i dw,
///   where (integral over W of cos theta_i dw) = pi F.
/// A(1) is the largest directional albedo; for a mirror A is A(1) for all F > 0, for a Lambertian surface A(F) = albedo
/// F. Uses the channel that reflects most.
///
/// The bound holds for every direction of viewer and light: it is a sum over cells of half vectors and viewers of the
/// largest value that Brdf::valueBound() allows in each, and so at least the true value: exact for Lambertian surfaces,
/// 1.3 to 2.2 times as large for highlights (narrow ones are farther off), more where the values rise toward the
/// horizon. It is infinite where no bound of the values is known.
class ReflectionBound {
 public:
  /// 0.05 to 0.2 s for models and tables, up to 1 s for anisotropic materials.
  explicit ReflectionBound(const Brdf& brdf);
  /// The exact bound of a Lambertian surface, A(F) = albedo F.
  static ReflectionBound ofDiffuse(double albedo);

  /// A(F), non-decreasing, 0 for F = 0. @param fraction F in [0, 1].
  double at(double fraction) const;
  double maxAlbedo() const { return at(1); }
  bool isBlack() const { return !(excess_.peak > 0); }
  /// Whether a finite bound is known.
  bool isFinite() const;

  /// For any t >= 0 the integral over W of f cos is at most pi F t plus the integral of max(0, f - t) cos over all
  /// directions. These are the levels t, 1/sr.
  static constexpr std::size_t levels = 96;
  static double level(std::size_t index);
  /// The integrals for all levels, and the largest value.
  struct Excess {
    std::array<double, levels> above{};
    double peak = 0;

    void include(double value, double measure);
    void raiseTo(const Excess& other);
    double at(double fraction) const;
  };

 private:
  ReflectionBound() = default;

  Excess excess_;  ///< the largest of all viewers
};

}  // namespace gonio::rendering
