// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/brdf/sampling_lobe.h"
#include "core/brdf/tabulated_lobe.h"
#include "core/rendering/reflection_bound.h"
#include "core/rendering/scene.h"

namespace gonio {

/// A material as rendering needs it: its BRDF, a density to sample directions from, and what the effect plan asks of
/// it. Immutable.
class RenderMaterial {
 public:
  /// Whether a lobe that is given also takes the place of a density of the BRDF's own.
  enum class LobeUse { whereNeeded, always };

  /// Models, factors and RGL files are sampled from their own densities. What has none (tables, codes, edits) is
  /// sampled from the lobe that is given, else from its own values (TabulatedLobe). Some ms; up to 50 ms for a sparse
  /// code, some 0.1 s for what is anisotropic.
  explicit RenderMaterial(std::shared_ptr<const Brdf> brdf, std::optional<SamplingLobe> lobe = std::nullopt,
                          LobeUse use = LobeUse::whereNeeded);
  /// Sampled from this lobe, unless it has a density of its own.
  RenderMaterial(std::shared_ptr<const Brdf> brdf, std::shared_ptr<const TabulatedLobe> lobe);

  const Brdf& brdf() const { return *brdf_; }
  /// Contracts of Brdf::sample() and pdf().
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const {
    return lobe_ ? lobe_->sample(wo, u) : tabulated_ ? mixture().sample(wo, u) : brdf_->sample(wo, u);
  }
  double pdf(const Direction& wi, const Direction& wo) const {
    return lobe_ ? lobe_->pdf(wi, wo) : tabulated_ ? mixture().pdf(wi, wo) : brdf_->pdf(wi, wo);
  }
  const ReflectionBound& bound() const { return bound_; }

 private:
  friend std::shared_ptr<const RenderMaterial> diffuseMaterial(const Rgb& reflectance);
  RenderMaterial(std::shared_ptr<const Brdf> brdf, const ReflectionBound& bound)
      : brdf_(std::move(brdf)), bound_(bound) {}

  TabulatedMixture mixture() const { return tabulatedMixture(*tabulated_); }

  std::shared_ptr<const Brdf> brdf_;
  std::optional<SamplingLobe> lobe_;
  std::shared_ptr<const TabulatedLobe> tabulated_;
  ReflectionBound bound_;
};

/// A Lambertian material; `reflectance` in linear RGB. Nothing is estimated.
std::shared_ptr<const RenderMaterial> diffuseMaterial(const Rgb& reflectance);

using RenderMaterials = std::vector<std::shared_ptr<const RenderMaterial>>;

/// The materials of a scene's slots: slot 0 has `first`, slot i has others[i - 1], or `first` again where there is
/// none.
RenderMaterials materialsInSlots(const Scene& scene, const std::shared_ptr<const RenderMaterial>& first,
                                 const RenderMaterials& others = {});

/// What each object of a scene is made of, in their order; null for what emits.
/// @param slotMaterials of the scene's slots, by their number.
/// @throws Error when the scene has more slots than are given.
std::vector<std::shared_ptr<const RenderMaterial>> bindMaterials(
    const Scene& scene, std::span<const std::shared_ptr<const RenderMaterial>> slotMaterials);

}  // namespace gonio
