// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/brdf/brdf.h"
#include "core/math/fast_functions.h"

/// Densities of directions for importance sampling. A density is a small value with
///   Direction sample(const Direction& wo, const glm::dvec2& u) const;  // u in [0, 1)^2; any point of the sphere, or
///                                                                      // the zero vector: the sample failed
///   double density(const Direction& w, const Direction& wo) const;     // 1/sr; integrates over the sphere to the
///                                                                      // fraction of samples that do not fail
/// Half-vector and cosine-power densities reach below the horizon, mostly for grazing viewers. DensityMixture mirrors
/// the lower hemisphere up (z becomes |z|), so that no sample fails because it is below the horizon: above the horizon
/// the density integrates to the fraction of samples that do not fail, 1 for most densities.
namespace gonio {

/// Cosine-weighted directions: for matte materials.
struct CosineDensity {
  Direction sample(const Direction&, const glm::dvec2& u) const {
    const double r = std::sqrt(u.x);
    const auto turn = fastSineAndCosine(u.y);
    return {r * turn.cosine, r * turn.sine, std::sqrt(1 - u.x)};
  }
  double density(const Direction& w, const Direction&) const { return std::max(0.0, w.z) / pi; }
};

/// Fractions of samples for a diffuse part and a highlight: proportional to their approximate albedos for white light,
/// but at least a tenth for each part with an albedo > 0, so that no part of the value is far above the density.
inline std::array<double, 2> mixtureFractions(double diffuseAlbedo, double specularAlbedo) {
  if (!(specularAlbedo > 0)) return {1, 0};
  if (!(diffuseAlbedo > 0)) return {0, 1};
  const double specular = std::clamp(specularAlbedo / (diffuseAlbedo + specularAlbedo), 0.1, 0.9);
  return {1 - specular, specular};
}

/// Fractions of any number of parts: proportional to their albedos, but at least about a tenth for each with an albedo
/// > 0.
template <std::size_t count>
std::array<double, count> mixtureFractions(const std::array<double, count>& albedos) {
  double total = 0, sum = 0;
  for (const double albedo : albedos) total += albedo;
  std::array<double, count> fractions{};
  if (!(total > 0)) {
    fractions[0] = 1;
    return fractions;
  }
  for (std::size_t i = 0; i < count; ++i) sum += fractions[i] = albedos[i] > 0 ? std::max(0.1, albedos[i] / total) : 0;
  for (double& fraction : fractions) fraction /= sum;
  return fractions;
}

/// A weighted sum of densities, mirrored to the upper hemisphere; implements Brdf::sample() and pdf() of a model.
template <typename... Densities>
class DensityMixture {
 public:
  /// @param fractions of the densities, >= 0, adding up to 1.
  DensityMixture(const std::array<double, sizeof...(Densities)>& fractions, Densities... densities)
      : fractions_(fractions), densities_(densities...) {}

  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const {
    return above(sampleOne<0>(wo, u.x, {u.y, u.z}), wo);
  }
  /// From two numbers: the first one selects the density, is rescaled to [0, 1) and used again, so that points that are
  /// well spread over the square are so in each density.
  DirectionSample sample(const Direction& wo, const glm::dvec2& u) const {
    return above(sampleReusing<0>(wo, u, 1), wo);
  }

  double pdf(const Direction& wi, const Direction& wo) const {
    if (!(wi.z > 0)) return 0;
    const Direction below(wi.x, wi.y, -wi.z);
    return sum<0>(wi, wo) + sum<0>(below, wo);
  }

 private:
  static constexpr double minCosine = 1e-9;

  DirectionSample above(Direction wi, const Direction& wo) const {
    if (wi == Direction(0)) return {{0, 0, 1}, 0};
    // Moves a sample on the horizon up by a negligible amount, so that its density is positive.
    wi.z = std::max(std::abs(wi.z), minCosine);
    return {wi, pdf(wi, wo)};
  }

  template <std::size_t index>
  Direction sampleOne(const Direction& wo, double which, const glm::dvec2& u) const {
    if constexpr (index + 1 < sizeof...(Densities))
      if (!(which < fractions_[index])) return sampleOne<index + 1>(wo, which - fractions_[index], u);
    return std::get<index>(densities_).sample(wo, u);
  }

  /// @param rest sum of the fractions from `index` on.
  template <std::size_t index>
  Direction sampleReusing(const Direction& wo, const glm::dvec2& u, double rest) const {
    if constexpr (index + 1 < sizeof...(Densities)) {
      const double part = fractions_[index] / rest;
      if (!(u.x < part))
        return sampleReusing<index + 1>(wo, {(u.x - part) / (1 - part), u.y}, rest - fractions_[index]);
      return std::get<index>(densities_).sample(wo, {u.x / part, u.y});
    } else {
      return std::get<index>(densities_).sample(wo, u);
    }
  }

  template <std::size_t index>
  double sum(const Direction& w, const Direction& wo) const {
    if constexpr (index == sizeof...(Densities))
      return 0;
    else
      return (fractions_[index] > 0 ? fractions_[index] * std::get<index>(densities_).density(w, wo) : 0) +
             sum<index + 1>(w, wo);
  }

  std::array<double, sizeof...(Densities)> fractions_;
  std::tuple<Densities...> densities_;
};

using CosineSampler = DensityMixture<CosineDensity>;
inline CosineSampler cosineSampler() { return {{1.0}, CosineDensity{}}; }

/// The usual mixture: a diffuse part and one highlight. @param diffuseAlbedo, specularAlbedo of the brightest channel.
template <typename Density>
DensityMixture<CosineDensity, Density> diffuseMixture(double diffuseAlbedo, double specularAlbedo, Density highlight) {
  return {mixtureFractions(diffuseAlbedo, specularAlbedo), CosineDensity{}, highlight};
}

}  // namespace gonio
