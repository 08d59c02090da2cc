// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/render_picture.h"

#include <algorithm>
#include <cassert>

namespace gonio {

namespace {

/// Isotropic and anisotropic materials share their noise only by equal frames.
EffectOverrides pictureOverrides() {
  EffectOverrides overrides;
  overrides[std::size_t(Effect::anisotropicFrames)] = true;
  return overrides;
}

/// Of paths that are recorded: what they carry are the factors of the BRDF values.
class UnitBrdf final : public Brdf {
 public:
  void evaluate(std::span<const DirectionPair>, std::span<Rgb> values) const override {
    std::ranges::fill(values, Rgb(1));
  }
};

}  // namespace

std::shared_ptr<const RenderMaterial> pictureMaterial(const Brdf& brdf, const RenderOptions& options) {
  // Without ownership: the caller keeps the BRDF for as long.
  const std::shared_ptr<const Brdf> borrowed(std::shared_ptr<const Brdf>(), &brdf);
  return std::make_shared<const RenderMaterial>(borrowed, options.lobe, RenderMaterial::LobeUse::always);
}

Image renderPicture(const std::shared_ptr<const RenderMaterial>& material, const Scene& scene,
                    const RenderOptions& options, const TaskControl& control) {
  const RenderMaterials materials = bindMaterials(scene, materialsInSlots(scene, material));
  Film film(options.width, options.height);
  PathTracer(scene, materials, planEffects(scene, materials, pictureOverrides()), options.seed)
      .accumulate(film, options.samples, control);
  return film.image();
}

Image renderPicture(const Brdf& brdf, const Scene& scene, const RenderOptions& options, const TaskControl& control) {
  control.throwIfStopped();
  return renderPicture(pictureMaterial(brdf, options), scene, options, control);
}

std::optional<RecordedPaths> recordPaths(const Scene& scene, const RenderOptions& options, const TaskControl& control) {
  assert(options.lobe);
  const auto hasOwnMaterial = [](const SceneObject& object) {
    return !object.emits() && !std::holds_alternative<MaterialSlot>(object.material);
  };
  if (std::ranges::any_of(scene.objects, hasOwnMaterial)) return std::nullopt;
  // Of a material that reflects everything: no other one needs more effects.
  const EffectPlan plan =
      planEffects(scene, bindMaterials(scene, materialsInSlots(scene, diffuseMaterial(Rgb(1)))), pictureOverrides());
  if (plan.reflections > 1) return std::nullopt;
  const UnitBrdf unit;
  const RenderMaterials materials = bindMaterials(scene, materialsInSlots(scene, pictureMaterial(unit, options)));
  return PathTracer(scene, materials, plan, options.seed)
      .record(options.width, options.height, options.samples, control);
}

Scene comparisonScene() { return sphereScene(studioEnvironment()); }

}  // namespace gonio
