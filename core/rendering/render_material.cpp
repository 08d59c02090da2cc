// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/render_material.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/sampling.h"
#include "core/sampling/fitted_densities.h"
#include "core/support/error.h"

namespace gonio::rendering {

namespace {

class DiffuseBrdf final : public Brdf {
 public:
  explicit DiffuseBrdf(const Rgb& reflectance) : value_(reflectance / pi) {}

  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i)
      values[i] = isBelowHorizon(pairs[i].wi) || isBelowHorizon(pairs[i].wo) ? Rgb(0) : value_;
  }
  bool hasImportanceSampling() const override { return true; }

 private:
  Rgb value_;
};

}  // namespace

/// The one with the least noise at equal time: variance goes with the second moment of the estimator, samples with
/// time.
/// @param tabulated null: made where it is needed.
RenderMaterial::Density RenderMaterial::chosenDensity(const Brdf& brdf,
                                                      std::shared_ptr<const TabulatedDensity> tabulated) {
  constexpr double nearTheLeast = 1.1;  // costs are known to a tenth, and no moment is below 1
  const bool hasOwn = brdf.hasImportanceSampling();
  const std::vector<MomentProbe> probes = hasOwn ? momentProbes(brdf) : std::vector<MomentProbe>();
  const double own = samplerMoment(probes, brdf) * brdf.samplingCost();
  if (hasOwn && own < nearTheLeast) return {};
  if (!tabulated) tabulated = std::make_shared<const TabulatedDensity>(brdf);
  const std::optional<SamplingDensity>& symmetric = tabulated->symmetricDensity();
  if (hasOwn && own < (symmetric ? samplerMoment(probes, *symmetric)
                                 : samplerMoment(probes, tabulatedMixture(*tabulated)) * TabulatedDensity::cost))
    return {};
  if (symmetric) return {.closedForm = symmetric};
  return {.tabulated = std::move(tabulated)};
}

RenderMaterial::RenderMaterial(std::shared_ptr<const Brdf> brdf, Density density)
    : brdf_(std::move(brdf)), density_(std::move(density)) {}

const ReflectionBound& RenderMaterial::bound() const {
  std::call_once(boundOnce_, [this] {
    if (!bound_) bound_.emplace(*brdf_);
  });
  return *bound_;
}

bool RenderMaterial::isBlack() const {
  // One value that is not 0 proves that it is not; it takes a bound to prove that it is.
  for (const double theta : {0.0, 0.5, 1.0})
    for (const double phi : {pi, 2.0, 0.0})
      if (maxChannel(brdf_->evaluate(fromSpherical(theta, phi), fromSpherical(theta, 0.0))) > 0) return false;
  return bound().isBlack();
}

RenderMaterial::RenderMaterial(std::shared_ptr<const Brdf> brdf, std::optional<SamplingDensity> density, DensityUse use)
    : RenderMaterial(brdf, density && (use == DensityUse::always || !brdf->hasImportanceSampling())
                               ? Density{.closedForm = density}
                               : chosenDensity(*brdf, nullptr)) {}

RenderMaterial::RenderMaterial(std::shared_ptr<const Brdf> brdf, std::shared_ptr<const TabulatedDensity> tabulated)
    : RenderMaterial(brdf, chosenDensity(*brdf, std::move(tabulated))) {}

std::shared_ptr<const RenderMaterial> RenderMaterial::withSampler(std::shared_ptr<const Brdf> brdf,
                                                                  std::shared_ptr<const Brdf> sampler) {
  return std::shared_ptr<const RenderMaterial>(
      new RenderMaterial(std::move(brdf), Density{.sampler = std::move(sampler)}));
}

std::shared_ptr<const RenderMaterial> diffuseMaterial(const Rgb& reflectance) {
  return std::shared_ptr<const RenderMaterial>(new RenderMaterial(std::make_shared<const DiffuseBrdf>(reflectance),
                                                                  ReflectionBound::ofDiffuse(maxChannel(reflectance))));
}

RenderMaterials materialsInSlots(const Scene& scene, const std::shared_ptr<const RenderMaterial>& first,
                                 const RenderMaterials& others) {
  RenderMaterials materials(std::size_t(materialSlotCount(scene)), first);
  for (std::size_t i = 1; i < materials.size() && i <= others.size(); ++i)
    if (others[i - 1]) materials[i] = others[i - 1];
  return materials;
}

std::vector<std::shared_ptr<const RenderMaterial>> bindMaterials(
    const Scene& scene, std::span<const std::shared_ptr<const RenderMaterial>> slotMaterials) {
  if (std::size_t(materialSlotCount(scene)) > slotMaterials.size())
    throw Error("the scene '" + scene.name + "' shows " + std::to_string(materialSlotCount(scene)) +
                " materials, found " + std::to_string(slotMaterials.size()));
  std::vector<std::shared_ptr<const RenderMaterial>> materials;
  for (const SceneObject& object : scene.objects) {
    if (object.emits())
      materials.push_back(nullptr);
    else if (const auto* diffuse = std::get_if<Diffuse>(&object.material))
      materials.push_back(diffuseMaterial(diffuse->reflectance));
    else
      materials.push_back(slotMaterials[std::size_t(std::get<MaterialSlot>(object.material).number)]);
  }
  return materials;
}

}  // namespace gonio::rendering
