// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/brdf/sampling_lobe.h"
#include "core/rendering/reflection_bound.h"
#include "core/rendering/scene.h"

namespace gonio {

/// A material as rendering needs it: its reflectance, a density to draw its reflections from, and what the effect plan
/// asks of it. Immutable.
class TracedMaterial {
 public:
  /// Whether a lobe that is given also takes the place of a density of the BRDF's own.
  enum class LobeUse { whereNeeded, always };

  /// Models and factors are sampled from their own densities; what has none (tables, codes, edits) from the lobe, which
  /// is estimated where absent. Some ms; up to 50 ms for a sparse code.
  explicit TracedMaterial(std::shared_ptr<const Brdf> brdf, std::optional<SamplingLobe> lobe = std::nullopt,
                          LobeUse use = LobeUse::whereNeeded);

  const Brdf& brdf() const { return *brdf_; }
  /// Contracts of Brdf::sample() and pdf().
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const {
    return lobe_ ? lobe_->sample(wo, u) : brdf_->sample(wo, u);
  }
  double pdf(const Direction& wi, const Direction& wo) const { return lobe_ ? lobe_->pdf(wi, wo) : brdf_->pdf(wi, wo); }
  const ReflectionBound& bound() const { return bound_; }

 private:
  friend std::shared_ptr<const TracedMaterial> diffuseMaterial(const Rgb& reflectance);
  TracedMaterial(std::shared_ptr<const Brdf> brdf, const ReflectionBound& bound)
      : brdf_(std::move(brdf)), bound_(bound) {}

  std::shared_ptr<const Brdf> brdf_;
  std::optional<SamplingLobe> lobe_;
  ReflectionBound bound_;
};

/// A Lambertian material; `reflectance` in linear RGB. Nothing is estimated.
std::shared_ptr<const TracedMaterial> diffuseMaterial(const Rgb& reflectance);

using TracedMaterials = std::vector<std::shared_ptr<const TracedMaterial>>;

/// The materials that a scene looks at: number 0 is `first`, number i is others[i - 1], or `first` again where there is
/// none.
TracedMaterials lookedAtMaterials(const Scene& scene, const std::shared_ptr<const TracedMaterial>& first,
                                  const TracedMaterials& others = {});

/// What each object of a scene is made of, in their order; null for what emits.
/// @param lookedAt the materials that are looked at, by their number.
/// @throws Error when the scene looks at more than are given.
std::vector<std::shared_ptr<const TracedMaterial>> bindMaterials(
    const Scene& scene, std::span<const std::shared_ptr<const TracedMaterial>> lookedAt);

}  // namespace gonio
