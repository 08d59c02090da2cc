// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/traced_material.h"

#include "core/support/error.h"

namespace gonio {

namespace {

std::optional<SamplingLobe> lobeOf(const Brdf& brdf, std::optional<SamplingLobe> lobe, TracedMaterial::LobeUse use) {
  if (brdf.samplesItself() && !(lobe && use == TracedMaterial::LobeUse::always)) return std::nullopt;
  return lobe ? lobe : estimateSamplingLobe(brdf);
}

class DiffuseBrdf final : public Brdf {
 public:
  explicit DiffuseBrdf(const Rgb& reflectance) : value_(reflectance / pi) {}

  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i)
      values[i] = isBelowHorizon(pairs[i].wi) || isBelowHorizon(pairs[i].wo) ? Rgb(0) : value_;
  }
  bool samplesItself() const override { return true; }

 private:
  Rgb value_;
};

}  // namespace

TracedMaterial::TracedMaterial(std::shared_ptr<const Brdf> brdf, std::optional<SamplingLobe> lobe, LobeUse use)
    : brdf_(std::move(brdf)),
      lobe_(lobeOf(*brdf_, lobe, use)),
      bound_(*brdf_, [this](const Direction& wo, const glm::dvec3& u) { return sample(wo, u); }) {}

std::shared_ptr<const TracedMaterial> diffuseMaterial(const Rgb& reflectance) {
  return std::shared_ptr<const TracedMaterial>(new TracedMaterial(std::make_shared<const DiffuseBrdf>(reflectance),
                                                                  ReflectionBound::ofDiffuse(maxChannel(reflectance))));
}

TracedMaterials lookedAtMaterials(const Scene& scene, const std::shared_ptr<const TracedMaterial>& first,
                                  const TracedMaterials& others) {
  TracedMaterials materials(std::size_t(lookedAtCount(scene)), first);
  for (std::size_t i = 1; i < materials.size() && i <= others.size(); ++i)
    if (others[i - 1]) materials[i] = others[i - 1];
  return materials;
}

std::vector<std::shared_ptr<const TracedMaterial>> bindMaterials(
    const Scene& scene, std::span<const std::shared_ptr<const TracedMaterial>> lookedAt) {
  if (std::size_t(lookedAtCount(scene)) > lookedAt.size())
    throw Error("the scene '" + scene.name + "' shows " + std::to_string(lookedAtCount(scene)) + " materials, found " +
                std::to_string(lookedAt.size()));
  std::vector<std::shared_ptr<const TracedMaterial>> materials;
  for (const SceneObject& object : scene.objects) {
    if (object.emits())
      materials.push_back(nullptr);
    else if (const auto* diffuse = std::get_if<Diffuse>(&object.material))
      materials.push_back(diffuseMaterial(diffuse->reflectance));
    else
      materials.push_back(lookedAt[std::size_t(std::get<LookedAt>(object.material).number)]);
  }
  return materials;
}

}  // namespace gonio
