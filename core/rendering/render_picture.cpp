// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/render_picture.h"

#include <algorithm>
#include <cassert>

namespace gonio::rendering {

namespace {

/// Isotropic and anisotropic materials share their noise only by equal frames.
EffectOverrides pictureOverrides() {
  EffectOverrides overrides;
  overrides[std::size_t(Effect::anisotropicFrames)] = true;
  return overrides;
}

/// The BRDF with which paths are recorded: with the value 1, the paths carry the factors of the BRDF values.
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
  return std::make_shared<const RenderMaterial>(borrowed, options.density, RenderMaterial::DensityUse::always);
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
  assert(options.density);
  const auto hasOwnMaterial = [](const SceneObject& object) {
    return !object.emits() && !std::holds_alternative<MaterialSlot>(object.material);
  };
  if (std::ranges::any_of(scene.objects, hasOwnMaterial)) return std::nullopt;
  // The plan of a material that reflects everything: no other material needs more effects.
  const EffectPlan plan =
      planEffects(scene, bindMaterials(scene, materialsInSlots(scene, diffuseMaterial(Rgb(1)))), pictureOverrides());
  // A mirror sees more of what is far than this material does.
  const bool reflectsTwice = std::ranges::any_of(plan.visible, [](const auto& visible) { return !visible.empty(); });
  if (reflectsTwice) return std::nullopt;
  const UnitBrdf unit;
  const RenderMaterials materials = bindMaterials(scene, materialsInSlots(scene, pictureMaterial(unit, options)));
  return PathTracer(scene, materials, plan, options.seed)
      .record(Film(options.width, options.height), options.samples, control);
}

Scene comparisonScene() { return sphereScene(studioEnvironment()); }

namespace {

constexpr std::uint64_t otherSeed = 0x9e3779b97f4a7c15;  // any other number
/// Samples whose paths are recorded.
constexpr std::size_t maxRecorded = 1 << 20;

Image mean(const metrics::PicturePair& halves) {
  Image image = halves[0];
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = 0.5f * (image.pixels[i] + halves[1].pixels[i]);
    image.alpha[i] = 0.5f * (image.alpha[i] + halves[1].alpha[i]);
  }
  return image;
}

ComparisonPicture pictureOf(metrics::PicturePair halves) {
  Image both = mean(halves);
  return {std::move(both), std::move(halves)};
}

}  // namespace

RenderedComparison::RenderedComparison(const Brdf& reference, RenderOptions options, const TaskControl& control)
    : RenderedComparison(comparisonScene(), reference, std::move(options), control) {}

RenderedComparison::RenderedComparison(Scene scene, const Brdf& reference, RenderOptions options,
                                       const TaskControl& control)
    : scene_(std::move(scene)) {
  if (!options.density) options.density = estimateSamplingDensity(reference);
  options.samples = (options.samples + 1) / 2;
  options_ = {options, options};
  options_[1].seed ^= otherSeed;
  if (std::size_t(options.width) * std::size_t(options.height) * std::size_t(2 * options.samples) <= maxRecorded)
    for (std::size_t half = 0; half < 2; ++half)
      paths_[half] = recordPaths(scene_, options_[half], control.between(0.3 * double(half), 0.3 * double(half + 1)));
  reference_ = render(reference, control.between(0.6, 1));
}

ComparisonPicture RenderedComparison::render(const Brdf& test, const TaskControl& control) const {
  if (!paths_[0] || !paths_[1]) return trace(test, control);
  return pictureOf(
      {paths_[0]->picture(test, control.between(0, 0.5)), paths_[1]->picture(test, control.between(0.5, 1))});
}

ComparisonPicture RenderedComparison::trace(const Brdf& test, const TaskControl& control) const {
  const auto material = pictureMaterial(test, options_[0]);
  return pictureOf({renderPicture(material, scene_, options_[0], control.between(0, 0.5)),
                    renderPicture(material, scene_, options_[1], control.between(0.5, 1))});
}

double RenderedComparison::signalToNoiseRatio(const ComparisonPicture& picture) const {
  return metrics::signalToNoiseRatio(reference_.halves, picture.halves);
}

double RenderedComparison::peakSignalToNoiseRatio(const ComparisonPicture& picture) const {
  return metrics::peakSignalToNoiseRatio(reference_.halves, picture.halves);
}

}  // namespace gonio::rendering
