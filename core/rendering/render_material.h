// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "core/brdf/brdf.h"
#include "core/rendering/reflection_bound.h"
#include "core/rendering/scene.h"
#include "core/sampling/fitted_densities.h"
#include "core/sampling/tabulated_density.h"

namespace gonio::rendering {

/// A material for rendering: its BRDF, a density for importance sampling, and the bound for the effect plan. Immutable.
class RenderMaterial {
 public:
  /// When a given density is used: only if the BRDF has no importance sampling of its own, or always.
  enum class DensityUse { whereNeeded, always };

  /// The density is `density` if given and the BRDF has no importance sampling of its own (or DensityUse::always).
  /// Otherwise it is the BRDF's own (models, factors, RGL files), a TabulatedDensity or its closed-form density,
  /// whichever gives the least noise at equal time. Takes a few ms; about 0.3 s for a sparse code, about 0.1 s for
  /// anisotropic materials.
  explicit RenderMaterial(std::shared_ptr<const Brdf> brdf, std::optional<SamplingDensity> density = std::nullopt,
                          DensityUse use = DensityUse::whereNeeded);
  /// The same with an existing tabulated density.
  RenderMaterial(std::shared_ptr<const Brdf> brdf, std::shared_ptr<const TabulatedDensity> tabulated);
  /// With the importance sampling of another BRDF, e.g. of factors of the material (sampledBy()).
  static std::shared_ptr<const RenderMaterial> withSampler(std::shared_ptr<const Brdf> brdf,
                                                           std::shared_ptr<const Brdf> sampler);

  const Brdf& brdf() const { return *brdf_; }
  /// As Brdf::sample() and pdf(); densities that this class chose use u.y to select the component as well, and leave
  /// u.x unused.
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const {
    const auto& [closedForm, tabulated, sampler] = density_;
    const glm::dvec2 pair(u.y, u.z);
    return closedForm  ? closedForm->sample(wo, pair)
           : tabulated ? tabulatedMixture(*tabulated).sample(wo, pair)
                       : (sampler ? sampler : brdf_)->sample(wo, u);
  }
  double pdf(const Direction& wi, const Direction& wo) const {
    const auto& [closedForm, tabulated, sampler] = density_;
    return closedForm  ? closedForm->pdf(wi, wo)
           : tabulated ? tabulatedMixture(*tabulated).pdf(wi, wo)
                       : (sampler ? sampler : brdf_)->pdf(wi, wo);
  }
  /// Computed at the first call, see ReflectionBound.
  const ReflectionBound& bound() const;
  /// Whether it certainly reflects nothing from any direction to any other.
  bool isBlack() const;

 private:
  friend std::shared_ptr<const RenderMaterial> diffuseMaterial(const Rgb& reflectance);
  RenderMaterial(std::shared_ptr<const Brdf> brdf, const ReflectionBound& bound)
      : brdf_(std::move(brdf)), bound_(bound) {}

  /// At most one of them; none: the BRDF's own density.
  struct Density {
    std::optional<SamplingDensity> closedForm = {};
    std::shared_ptr<const TabulatedDensity> tabulated = {};
    std::shared_ptr<const Brdf> sampler = {};
  };
  static Density chosenDensity(const Brdf& brdf, std::shared_ptr<const TabulatedDensity> tabulated);
  RenderMaterial(std::shared_ptr<const Brdf> brdf, Density density);

  std::shared_ptr<const Brdf> brdf_;
  Density density_;
  mutable std::once_flag boundOnce_;
  mutable std::optional<ReflectionBound> bound_;
};

/// A Lambertian material with an exact bound. @param reflectance albedo, linear RGB.
std::shared_ptr<const RenderMaterial> diffuseMaterial(const Rgb& reflectance);

using RenderMaterials = std::vector<std::shared_ptr<const RenderMaterial>>;

/// The materials of a scene's slots: `first` in slot 0, others[i - 1] in slot i, or `first` if there is none.
RenderMaterials materialsInSlots(const Scene& scene, const std::shared_ptr<const RenderMaterial>& first,
                                 const RenderMaterials& others = {});

/// The material of each object of a scene, in their order; null for emitting objects.
/// @param slotMaterials of the scene's slots, by number.
/// @throws Error if the scene has more slots than materials.
std::vector<std::shared_ptr<const RenderMaterial>> bindMaterials(
    const Scene& scene, std::span<const std::shared_ptr<const RenderMaterial>> slotMaterials);

}  // namespace gonio::rendering
