// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/render_material.h"

#include "core/support/error.h"

namespace gonio {

namespace {

std::optional<SamplingLobe> lobeOf(const Brdf& brdf, std::optional<SamplingLobe> lobe, RenderMaterial::LobeUse use) {
  if (brdf.hasImportanceSampling() && !(lobe && use == RenderMaterial::LobeUse::always)) return std::nullopt;
  return lobe;
}

std::shared_ptr<const TabulatedLobe> tabulatedLobeOf(const Brdf& brdf, const std::optional<SamplingLobe>& lobe) {
  return lobe || brdf.hasImportanceSampling() ? nullptr : std::make_shared<const TabulatedLobe>(brdf);
}

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

RenderMaterial::RenderMaterial(std::shared_ptr<const Brdf> brdf, std::optional<SamplingLobe> lobe, LobeUse use)
    : brdf_(std::move(brdf)),
      lobe_(lobeOf(*brdf_, lobe, use)),
      tabulated_(tabulatedLobeOf(*brdf_, lobe_)),
      bound_(*brdf_, [this](const Direction& wo, const glm::dvec3& u) { return sample(wo, u); }) {}

RenderMaterial::RenderMaterial(std::shared_ptr<const Brdf> brdf, std::shared_ptr<const TabulatedLobe> lobe)
    : brdf_(std::move(brdf)),
      tabulated_(brdf_->hasImportanceSampling() ? nullptr : std::move(lobe)),
      bound_(*brdf_, [this](const Direction& wo, const glm::dvec3& u) { return sample(wo, u); }) {}

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

}  // namespace gonio
