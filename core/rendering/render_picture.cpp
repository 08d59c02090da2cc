// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/render_picture.h"

namespace gonio {

std::shared_ptr<const RenderMaterial> pictureMaterial(const Brdf& brdf, const RenderOptions& options) {
  // Without ownership: the caller keeps the BRDF for as long.
  const std::shared_ptr<const Brdf> borrowed(std::shared_ptr<const Brdf>(), &brdf);
  return std::make_shared<const RenderMaterial>(borrowed, options.lobe, RenderMaterial::LobeUse::always);
}

Image renderPicture(const std::shared_ptr<const RenderMaterial>& material, const Scene& scene,
                    const RenderOptions& options, const TaskControl& control) {
  const RenderMaterials materials = bindMaterials(scene, materialsInSlots(scene, material));
  EffectOverrides overrides;
  // Isotropic and anisotropic materials share their noise only by equal frames.
  overrides[std::size_t(Effect::anisotropicFrames)] = true;
  Film film(options.width, options.height);
  PathTracer(scene, materials, planEffects(scene, materials, overrides), options.seed)
      .accumulate(film, options.samples, control);
  return film.image();
}

Image renderPicture(const Brdf& brdf, const Scene& scene, const RenderOptions& options, const TaskControl& control) {
  control.throwIfStopped();
  return renderPicture(pictureMaterial(brdf, options), scene, options, control);
}

Scene comparisonScene() { return sphereScene(studioEnvironment()); }

}  // namespace gonio
