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

  /// Models, factors and RGL files have densities of their own, used where they have less noise at equal time than a
  /// TabulatedLobe, which serves all others (tables, codes, edits); in its place the lobe that is given. Some ms; up to
  /// 50 ms for a sparse code, some 0.1 s for what is anisotropic.
  explicit RenderMaterial(std::shared_ptr<const Brdf> brdf, std::optional<SamplingLobe> lobe = std::nullopt,
                          LobeUse use = LobeUse::whereNeeded);
  /// The same with its tabulated lobe, which is known.
  RenderMaterial(std::shared_ptr<const Brdf> brdf, std::shared_ptr<const TabulatedLobe> lobe);

  const Brdf& brdf() const { return *brdf_; }
  /// Contracts of Brdf::sample() and pdf().
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const {
    const auto& [lobe, tabulated] = density_;
    return lobe ? lobe->sample(wo, u) : tabulated ? tabulatedMixture(*tabulated).sample(wo, u) : brdf_->sample(wo, u);
  }
  double pdf(const Direction& wi, const Direction& wo) const {
    const auto& [lobe, tabulated] = density_;
    return lobe ? lobe->pdf(wi, wo) : tabulated ? tabulatedMixture(*tabulated).pdf(wi, wo) : brdf_->pdf(wi, wo);
  }
  const ReflectionBound& bound() const { return bound_; }

 private:
  friend std::shared_ptr<const RenderMaterial> diffuseMaterial(const Rgb& reflectance);
  RenderMaterial(std::shared_ptr<const Brdf> brdf, const ReflectionBound& bound)
      : brdf_(std::move(brdf)), bound_(bound) {}

  /// One of the two, or nothing: the BRDF's own.
  struct Density {
    std::optional<SamplingLobe> lobe = {};
    std::shared_ptr<const TabulatedLobe> tabulated = {};
  };
  static Density chosenDensity(const Brdf& brdf, std::shared_ptr<const TabulatedLobe> lobe);
  RenderMaterial(std::shared_ptr<const Brdf> brdf, Density density);

  std::shared_ptr<const Brdf> brdf_;
  Density density_;
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
