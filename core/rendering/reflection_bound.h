// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <functional>

#include "core/brdf/brdf.h"

namespace gonio {

/// Upper bound A(F) of the radiance that a material reflects to a viewer from a light of radiance 1 that covers a
/// fraction F of the cosine-weighted hemisphere, at the position where the material reflects most:
///   A(F) = max over wo and over all regions W of the integral over W of f cos theta_i dw,
///   where (integral over W of cos theta_i dw) = pi F.
/// A(1) is the largest directional albedo; for a mirror A is A(1) for all F > 0, for a Lambertian surface A(F) = albedo
/// F. Uses the channel that reflects most. Estimated from samples of the material's density for viewers from 0 to 89
/// degrees (anisotropic materials: at four azimuths), so accurate to a few percent, not a strict bound.
class ReflectionBound {
 public:
  using Sampler = std::function<DirectionSample(const Direction& wo, const glm::dvec3& u)>;
  ReflectionBound(const Brdf& brdf, const Sampler& sampler);
  /// The exact bound of a Lambertian surface, A(F) = albedo F.
  static ReflectionBound ofDiffuse(double albedo);

  /// A(F), non-decreasing, 0 for F = 0. @param fraction F in [0, 1].
  double at(double fraction) const;
  double maxAlbedo() const { return at(1); }
  bool isBlack() const { return !(maxAlbedo() > 0); }

 private:
  ReflectionBound() = default;
  void include(const Brdf& brdf, const Sampler& sampler, const Direction& wo);

  static constexpr std::size_t steps = 64;  ///< uniform in the square root of the fraction, to resolve small F
  std::array<double, steps + 1> bound_{};
  double peak_ = 0;  ///< largest sampled BRDF value, 1/sr: A(F) <= pi F peak
};

}  // namespace gonio
