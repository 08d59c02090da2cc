// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <functional>
#include <memory>

#include "core/brdf/brdf.h"
#include "core/rendering/scene.h"
#include "core/sampling/fitted_densities.h"
#include "core/sampling/tabulated_density.h"

namespace gonio::rendering {

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

/// A material for rendering: its BRDF, a density for importance sampling, and the bound for the effect plan. Immutable.
class RenderMaterial {
 public:
  /// When a given density is used: only if the BRDF has no importance sampling of its own, or always.
  enum class DensityUse { whereNeeded, always };

  /// The density is `density` if given and the BRDF has no importance sampling of its own (or DensityUse::always).
  /// Otherwise it is the BRDF's own (models, factors, RGL files), a TabulatedDensity or its closed-form density,
  /// whichever gives the least noise at equal time. Takes a few ms; up to 50 ms for a sparse code, about 0.1 s for
  /// anisotropic materials.
  explicit RenderMaterial(std::shared_ptr<const Brdf> brdf, std::optional<SamplingDensity> density = std::nullopt,
                          DensityUse use = DensityUse::whereNeeded);
  /// The same with an existing tabulated density.
  RenderMaterial(std::shared_ptr<const Brdf> brdf, std::shared_ptr<const TabulatedDensity> tabulated);

  const Brdf& brdf() const { return *brdf_; }
  /// As Brdf::sample() and pdf().
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const {
    const auto& [closedForm, tabulated] = density_;
    return closedForm  ? closedForm->sample(wo, u)
           : tabulated ? tabulatedMixture(*tabulated).sample(wo, u)
                       : brdf_->sample(wo, u);
  }
  double pdf(const Direction& wi, const Direction& wo) const {
    const auto& [closedForm, tabulated] = density_;
    return closedForm  ? closedForm->pdf(wi, wo)
           : tabulated ? tabulatedMixture(*tabulated).pdf(wi, wo)
                       : brdf_->pdf(wi, wo);
  }
  const ReflectionBound& bound() const { return bound_; }

 private:
  friend std::shared_ptr<const RenderMaterial> diffuseMaterial(const Rgb& reflectance);
  RenderMaterial(std::shared_ptr<const Brdf> brdf, const ReflectionBound& bound)
      : brdf_(std::move(brdf)), bound_(bound) {}

  /// At most one of the two; none: the BRDF's own density.
  struct Density {
    std::optional<SamplingDensity> closedForm = {};
    std::shared_ptr<const TabulatedDensity> tabulated = {};
  };
  static Density chosenDensity(const Brdf& brdf, std::shared_ptr<const TabulatedDensity> tabulated);
  RenderMaterial(std::shared_ptr<const Brdf> brdf, Density density);

  std::shared_ptr<const Brdf> brdf_;
  Density density_;
  ReflectionBound bound_;
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
