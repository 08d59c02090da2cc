// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/matching/ball_pictures.h"

#include <algorithm>
#include <cmath>

#include "core/math/parallel.h"
#include "core/rendering/path_tracer.h"

namespace gonio::matching {

namespace {

/// Pictures whose values are remembered: one and its neighbour along each control of the model.
constexpr std::size_t remembered = 5;
constexpr std::size_t cellsPerBlock = 16;

models::ParameterValues withoutColours(models::ParameterValues controls) {
  for (const auto control : {editing::ArtistControl::tint, editing::ArtistControl::saturation})
    controls.values[std::size_t(control)] =
        models::defaultParameters(editing::artistControls()).values[std::size_t(control)];
  return controls;
}

/// The placeholder with which paths are recorded.
class ConstantBrdf final : public Brdf {
 public:
  void evaluate(std::span<const DirectionPair>, std::span<Rgb> values) const override {
    std::ranges::fill(values, Rgb(1));
  }
};

const rendering::Sphere* sphereInSlot(const rendering::SceneObject& object) {
  const bool hasSlot = std::holds_alternative<rendering::MaterialSlot>(object.material) && !object.emits();
  return hasSlot ? std::get_if<rendering::Sphere>(&object.shape) : nullptr;
}

}  // namespace

std::shared_ptr<const Brdf> MatchedMaterial::with(const models::ParameterValues& controls) const {
  editing::EditList changed = edits;
  std::get<editing::DifferentialEdit>(changed[index].content).controls = controls;
  return editing::applyEdits(base, changed);
}

rendering::Sphere ballOf(const rendering::Scene& scene) {
  for (const rendering::SceneObject& object : scene.objects)
    if (const rendering::Sphere* sphere = sphereInSlot(object)) return *sphere;
  return {};
}

BallView ballView(const rendering::Scene& scene) {
  BallView view{.scene = scene};
  view.scene.showEnvironment = view.scene.blurBackground = false;
  const rendering::Sphere sphere = ballOf(scene);
  std::erase_if(view.scene.objects, [](const rendering::SceneObject& object) { return !object.emits(); });
  view.scene.objects.push_back({.name = "ball", .shape = sphere});
  if (rendering::lightsOf(view.scene).empty()) throw Error("the scene has no light: choose an environment");
  rendering::OrbitCamera& camera = view.scene.camera;
  camera.target = sphere.centre;
  if (camera.fieldOfView > 0) {
    // The outline of the ball fills the picture.
    camera.distance = std::max(camera.distance, 1.05 * sphere.radius);
    camera.fieldOfView = 2 * std::asin(sphere.radius / camera.distance);
  } else {
    view.margin = rendering::cameraFrame(camera).halfExtent / sphere.radius;
  }
  return view;
}

BallPictures::BallPictures(MatchedMaterial material, const BallView& view, const ReferenceCells& cells, int samples,
                           const std::shared_ptr<const TabulatedDensity>& density, const TaskControl& control)
    : material_(std::move(material)),
      isLast_(editing::isIdentity(std::span(material_.edits).subspan(material_.index + 1))) {
  const auto placeholder =
      std::make_shared<const rendering::RenderMaterial>(std::make_shared<const ConstantBrdf>(), density);
  const auto materials = rendering::bindMaterials(view.scene, rendering::materialsInSlots(view.scene, placeholder));
  rendering::EffectOverrides overrides;
  overrides[std::size_t(rendering::Effect::anisotropicFrames)] = true;
  const rendering::EffectPlan plan = rendering::planEffects(view.scene, materials, overrides);
  const rendering::Film film{cells.side, cells.side, {cells.centre / view.margin, cells.halfSize / view.margin}};
  const std::size_t count = cells.values.size();
  std::vector<rendering::RecordedPaths> halves;
  for (std::uint64_t seed = 1; seed <= 2; ++seed)
    halves.push_back(rendering::PathTracer(view.scene, materials, plan, seed).record(film, samples, control));
  first_.assign(2 * count + 1, 0);
  const auto forEachPath = [&](const auto& use) {
    for (std::size_t half = 0; half < 2; ++half)
      for (const auto& row : halves[half].rows())
        for (std::size_t i = 0; i < row.pairs.size(); ++i)
          if (cells.isUsed(row.pixels[i])) use(half * count + row.pixels[i], row, i);
  };
  forEachPath([&](std::size_t cell, const auto&, std::size_t) { ++first_[cell + 1]; });
  for (std::size_t cell = 0; cell < 2 * count; ++cell) first_[cell + 1] += first_[cell];
  pairs_.resize(first_.back());
  weights_.resize(first_.back());
  std::vector<std::size_t> next = first_;
  forEachPath([&](std::size_t cell, const auto& row, std::size_t i) {
    const std::size_t place = next[cell]++;
    pairs_[place] = row.pairs[i];
    weights_[place] = row.weights[i] / double(samples);
  });
}

const std::vector<Rgb>& BallPictures::valuesOf(const models::ParameterValues& controls, const TaskControl& control) {
  const auto known = std::ranges::find(values_, controls, &Values::controls);
  if (known != values_.end()) {
    values_.splice(values_.begin(), values_, known);
    return values_.front().values;
  }
  std::vector<Rgb> values;
  if (values_.size() == remembered) {
    values = std::move(values_.back().values);
    values_.pop_back();
  }
  values.resize(pairs_.size());
  const std::shared_ptr<const Brdf> brdf = material_.with(controls);
  constexpr std::size_t pairsPerBlock = 1024;
  parallelForBlocks(pairs_.size(), pairsPerBlock,
                    [&](std::size_t begin, std::size_t end) {
                      brdf->evaluate(std::span(pairs_).subspan(begin, end - begin),
                                     std::span(values).subspan(begin, end - begin));
                    },
                    {control.stop, {}});
  values_.push_front({controls, std::move(values)});
  return values_.front().values;
}

std::array<std::vector<Rgb>, 2> BallPictures::render(const models::ParameterValues& controls,
                                                     const TaskControl& control) {
  const std::vector<Rgb>& values = valuesOf(isLast_ ? withoutColours(controls) : controls, control);
  const double strength = material_.edits[material_.index].strength;
  const glm::dmat3 colours = isLast_ ? editing::colourMatrix(controls) : glm::dmat3(1);
  const std::size_t count = (first_.size() - 1) / 2;
  std::array<std::vector<Rgb>, 2> halves;
  halves.fill(std::vector<Rgb>(count, Rgb(0)));
  parallelForBlocks(2 * count, cellsPerBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
      for (std::size_t i = first_[cell]; i < first_[cell + 1]; ++i) {
        const Rgb& value = values[i];
        // As editing::applyEdits() does.
        const Rgb coloured = glm::max(glm::min(Rgb(0), value), value + strength * (colours * value - value));
        halves[cell / count][cell % count] += coloured * weights_[i];
      }
  });
  return halves;
}

}  // namespace gonio::matching
