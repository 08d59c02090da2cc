// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <functional>

#include "core/brdf/brdf.h"

namespace gonio {

/// How much of a light of radiance 1 a material can send on to one viewer, when that light fills a fraction F of the
/// cosine-weighted hemisphere and lies where the material reflects most:
///   A(F) = max over wo of max over regions W with integral over W of cos = pi F of  integral over W of f cos dw.
/// A(1) is the largest directional albedo; of a mirror A rises to it at once, of a Lambertian surface A(F) = albedo F.
/// In the channel that reflects most. Estimated from directions sampled from the material's own density, for viewers
/// from 0 to 89 degrees (of an anisotropic material at four azimuths): within some percent, no strict bound.
class ReflectionBound {
 public:
  using Sampler = std::function<DirectionSample(const Direction& wo, const glm::dvec3& u)>;
  ReflectionBound(const Brdf& brdf, const Sampler& sampler);
  /// Of a Lambertian surface, exact: A(F) = albedo F.
  static ReflectionBound ofDiffuse(double albedo);

  /// @param fraction F in [0, 1]. Never falls with it; 0 at 0.
  double at(double fraction) const;
  double largestAlbedo() const { return at(1); }
  bool isBlack() const { return !(largestAlbedo() > 0); }

 private:
  ReflectionBound() = default;
  void include(const Brdf& brdf, const Sampler& sampler, const Direction& wo);

  static constexpr std::size_t steps = 64;  ///< of the square root of the fraction: fine where mirrors rise
  std::array<double, steps + 1> bound_{};
  double peak_ = 0;  ///< the largest value that was drawn, 1/sr: A(F) is at most pi F times it
};

}  // namespace gonio
