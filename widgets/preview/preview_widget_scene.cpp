// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// What the preview shows: subjects, scene, and the plan that follows from both.
#include <algorithm>

#include "widgets/preview/preview_overlay.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::widgets {

void PreviewWidget::setMaterial(std::shared_ptr<const TabulatedBrdf> table, const SamplingLobe& lobe) {
  setSubject(tableSubject(std::move(table), lobe));
}

void PreviewWidget::setSubject(const PreviewSubject& subject, const QString& name) {
  const bool another = subject.table() != first_.subject.table();
  changeSubject(first_, subject, name);
  if (another) budget_.reset();
  if (!failure_.isEmpty()) return;
  overlay_->setHint(subject.isEmpty() ? tr("Open a measured material (Ctrl+O), drop a file here,\n"
                                           "or double-click one in the library.")
                                      : QString());
  if (subject.isEmpty()) overlay_->setStatus({});
}

void PreviewWidget::setOther(const PreviewSubject& subject, const QString& name) {
  changeSubject(second_, subject, name);
}

void PreviewWidget::changeSubject(Side& side, const PreviewSubject& subject, const QString& name) {
  side.name = name;
  showOverlay();
  if (sameSubject(subject, side.subject)) return;
  const bool wasPlain = side.subject.isMeasured();
  side.subject = subject;
  PreviewSubject drawn = subject;
  // The lobe of the step before serves until the new one is known.
  if (!subject.isMeasured() && !wasPlain) drawn.lobe = side.picture.subject().lobe;
  side.picture.setSubject(drawn);
  side.tracer.stop();
  if (subject.isEmpty()) side.material.reset();
  side.estimator.request(subject);
  changed();
}

void PreviewWidget::adopt(Side& side, const MaterialEstimate& estimate) {
  side.material = estimate.material;
  if (!similarLobes(estimate.lobe, side.picture.subject().lobe)) side.picture.setLobe(estimate.lobe);
  plan(side);
  trace(side);
  if (&side == &first_) Q_EMIT planChanged(side.plan);
  update();
}

/// What the side's picture simulates; its picture starts anew only where that changes.
void PreviewWidget::plan(Side& side) {
  static const std::shared_ptr<const RenderMaterial> grey = diffuseMaterial(Rgb(0.5));
  adoptPlan(side, previewPlan(scene_, side.material ? side.material : grey, overrides_, others_));
}

void PreviewWidget::adoptPlan(Side& side, const EffectPlan& plan) {
  const bool another = !(plan == side.plan);
  side.plan = plan;
  if (!isTraced()) side.picture.setScene(scene_, side.plan);
  if (another && &side == &first_) Q_EMIT planChanged(side.plan);
}

void PreviewWidget::trace(Side& side) {
  if (!isTraced() || !side.material || side.subject.isEmpty()) return side.tracer.stop();
  if (&side == &second_ && !isComparing()) return;
  side.tracer.trace(scene_, materialsInSlots(scene_, side.material, others_), side.plan, pictureSize(),
                    wantedSamples());
}

void PreviewWidget::showScene(const Scene& scene) {
  home_ = scene;
  budget_.reset();
  setScene(scene);
}

void PreviewWidget::setScene(const Scene& scene) {
  scene_ = scene;
  for (Side* side : {&first_, &second_}) plan(*side);
  showSceneChange();
}

void PreviewWidget::setView(const OrbitCamera& camera, double environmentRotation) {
  scene_.camera = camera;
  scene_.environmentRotation = environmentRotation;
  for (Side* side : {&first_, &second_}) {
    EffectPlan plan = side->plan;
    updateForCamera(plan, scene_, overrides_);
    adoptPlan(*side, plan);
  }
  showSceneChange();
}

void PreviewWidget::showSceneChange() {
  for (Side* side : {&first_, &second_}) trace(*side);
  changed();
  Q_EMIT sceneChanged(scene_);
}

void PreviewWidget::setEnvironment(const std::shared_ptr<const EnvironmentMap>& environment) {
  Scene scene = scene_;
  scene.environment = environment;
  const std::vector<DirectionalLight>& own = home_.directionalLights;
  if (!environment)
    scene.directionalLights = own.empty() ? std::vector{DirectionalLight{}} : own;
  else
    scene.directionalLights = home_.environment ? own : std::vector<DirectionalLight>{};
  setScene(scene);
}

bool PreviewWidget::isTraced() const {
  if (!SceneUniforms::canDraw(scene_)) return true;
  const auto shown = std::min(others_.size(), std::size_t(std::max(1, materialSlotCount(scene_)) - 1));
  return std::any_of(others_.begin(), others_.begin() + std::ptrdiff_t(shown),
                     [](const auto& material) { return material != nullptr; });
}

void PreviewWidget::setOthers(const RenderMaterials& others) {
  if (others == others_) return;
  others_ = others;
  restart();
  setScene(scene_);
}

void PreviewWidget::setOverrides(const EffectOverrides& overrides) {
  if (overrides == overrides_) return;
  overrides_ = overrides;
  setScene(scene_);
}

}  // namespace gonio::widgets
