// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_content.h"

#include <algorithm>

#include "core/rendering/scene_file.h"
#include "widgets/preview/gl/scene_uniforms.h"

namespace gonio::widgets {

namespace {

/// A film with fewer is noisier than what a graphics card has drawn by then.
constexpr int minFilmSamples = 16;

bool hasMeshes(const rendering::Scene& scene) {
  return std::ranges::any_of(scene.objects, [](const rendering::SceneObject& object) {
    return std::holds_alternative<rendering::MeshShape>(object.shape);
  });
}

}  // namespace

PreviewContent::PreviewContent(QObject* parent) : QObject(parent) {
  m_rest.setSingleShot(true);
  m_rest.setInterval(timeToRest);
  connect(&m_rest, &QTimer::timeout, this, [this] {
    startTracing(m_first);
    startTracing(m_second);
  });
  connectSide(m_first);
  connectSide(m_second);
  showScene(rendering::openScene(rendering::bundledSceneNames().front()));
}

void PreviewContent::connectSide(PreviewSide& side) {
  connect(&side, &PreviewSide::failed, this, &PreviewContent::failed);
  connect(&side.tracer(), &SceneTracer::advanced, this, &PreviewContent::refined);
  connect(&side, &PreviewSide::estimated, this, [this, &side] {
    side.setPlan(planOf(side));
    trace(side);
    if (&side == &m_first) Q_EMIT planChanged(side.plan());
    Q_EMIT refined();
  });
}

void PreviewContent::setSubject(const PreviewSubject& subject, const QString& name) { show(m_first, subject, name); }

void PreviewContent::setSecond(const PreviewSubject& subject, const QString& name) { show(m_second, subject, name); }

void PreviewContent::show(PreviewSide& side, const PreviewSubject& subject, const QString& name) {
  const bool renamed = name != side.name();
  side.setName(name);
  if (side.setSubject(subject))
    Q_EMIT changed();
  else if (renamed)
    Q_EMIT comparisonChanged();
}

void PreviewContent::setComparison(const PreviewComparison& comparison) {
  if (comparison == m_comparison) return;
  m_comparison = comparison;
  traceBoth();
  Q_EMIT comparisonChanged();
}

bool PreviewContent::isComparing() const {
  return m_comparison.mode != CompareMode::off && !m_first.subject().isEmpty() && !m_second.subject().isEmpty();
}

/// The effects that the side's picture simulates.
rendering::EffectPlan PreviewContent::planOf(const PreviewSide& side) const {
  static const std::shared_ptr<const rendering::RenderMaterial> grey = rendering::diffuseMaterial(Rgb(0.5));
  return previewPlan(m_scene, side.material() ? side.material() : grey, m_overrides, otherSlotMaterials(),
                     m_thresholds);
}

/// Both before anybody hears of it: who does may request a picture, whose plans must be those of its scene.
void PreviewContent::setPlans(const rendering::EffectPlan& first, const rendering::EffectPlan& second) {
  const bool another = !(first == m_first.plan());
  m_first.setPlan(first);
  m_second.setPlan(second);
  if (another) Q_EMIT planChanged(first);
}

void PreviewContent::setCheckedPlan(const rendering::EffectPlan& checked) {
  if (checked == m_first.plan()) return;
  setPlans(checked, m_second.plan());
  trace(m_first);
  Q_EMIT changed();
}

void PreviewContent::trace(PreviewSide& side) {
  if (tracing() == Tracing::always) return startTracing(side);
  side.tracer().stop();
  if (tracing() == Tracing::atRest) m_rest.start();
}

void PreviewContent::startTracing(PreviewSide& side) {
  if (tracing() == Tracing::never || !side.material() || side.subject().isEmpty()) return side.tracer().stop();
  if (&side == &m_second && !isComparing()) return;
  side.tracer().trace(m_scene, rendering::materialsInSlots(m_scene, side.material(), otherSlotMaterials()), side.plan(),
                      pictureSize(), wantedSamples());
}

void PreviewContent::traceBoth() {
  trace(m_first);
  trace(m_second);
}

void PreviewContent::showScene(const rendering::Scene& scene) {
  m_home = scene;
  rendering::Scene lit = scene;
  if (m_environment) light(lit);
  if (m_background) m_background->show(lit);
  setScene(lit);
}

void PreviewContent::setScene(const rendering::Scene& scene) {
  m_scene = scene;
  setPlans(planOf(m_first), planOf(m_second));
  notifySceneChange();
}

void PreviewContent::setView(const rendering::OrbitCamera& camera, double environmentRotation) {
  m_scene.camera = camera;
  m_scene.environmentRotation = environmentRotation;
  rendering::EffectPlan first = m_first.plan(), second = m_second.plan();
  for (rendering::EffectPlan* plan : {&first, &second}) rendering::updateForCamera(*plan, m_scene, m_overrides);
  setPlans(first, second);
  notifySceneChange();
}

void PreviewContent::notifySceneChange() {
  traceBoth();
  Q_EMIT changed();
  Q_EMIT sceneChanged(m_scene);
}

/// Puts the chosen environment into a scene.
void PreviewContent::light(rendering::Scene& scene) const {
  const std::shared_ptr<const rendering::EnvironmentMap>& environment = *m_environment;
  const std::vector<rendering::DirectionalLight>& own = m_home.directionalLights;
  scene.environment = environment;
  if (!environment)
    scene.directionalLights = own.empty() ? std::vector{rendering::DirectionalLight{}} : own;
  else
    scene.directionalLights = m_home.environment ? own : std::vector<rendering::DirectionalLight>{};
}

void PreviewContent::setEnvironment(const std::shared_ptr<const rendering::EnvironmentMap>& environment) {
  m_environment = environment;
  rendering::Scene scene = m_scene;
  light(scene);
  setScene(scene);
}

void PreviewContent::resetEnvironment() {
  m_environment.reset();
  rendering::Scene scene = m_scene;
  scene.environment = m_home.environment;
  scene.directionalLights = m_home.directionalLights;
  setScene(scene);
}

void PreviewContent::Background::show(rendering::Scene& scene) const {
  scene.showEnvironment = shown;
  scene.blurBackground = blurred;
}

void PreviewContent::setBackground(bool shown, bool blurred) {
  m_background = Background{shown, blurred};
  rendering::Scene scene = m_scene;
  m_background->show(scene);
  setScene(scene);
}

bool PreviewContent::showsOtherSlotMaterials() const {
  const auto shown =
      std::min(m_otherSlotMaterials.size(), std::size_t(std::max(1, rendering::materialSlotCount(m_scene)) - 1));
  return std::any_of(m_otherSlotMaterials.begin(), m_otherSlotMaterials.begin() + std::ptrdiff_t(shown),
                     [](const SlotMaterial& other) { return other.material != nullptr; });
}

Tracing PreviewContent::tracing() const {
  if (!SceneUniforms::canDraw(m_scene)) return Tracing::always;
  // The shader leaves out what one material reflects of another.
  const bool leavesOut = showsOtherSlotMaterials() && m_first.plan().reflections > 1;
  return leavesOut || (m_software && hasMeshes(m_scene)) ? Tracing::atRest : Tracing::never;
}

void PreviewContent::setSoftware(bool software) {
  if (software == m_software) return;
  m_software = software;
  traceBoth();
}

void PreviewContent::setOtherSlotMaterials(const std::vector<SlotMaterial>& materials) {
  m_otherSlotMaterials = materials;
  setScene(m_scene);
}

rendering::RenderMaterials PreviewContent::otherSlotMaterials() const {
  rendering::RenderMaterials materials;
  for (const SlotMaterial& other : m_otherSlotMaterials) materials.push_back(other.material);
  return materials;
}

void PreviewContent::setOverrides(const rendering::EffectOverrides& overrides) {
  if (overrides == m_overrides) return;
  m_overrides = overrides;
  setScene(m_scene);
}

void PreviewContent::setReflectionLimit(int reflections) {
  const int limit = reflections > 0 ? reflections : rendering::EffectThresholds{}.maxReflections;
  if (limit == m_thresholds.maxReflections) return;
  m_thresholds.maxReflections = limit;
  setScene(m_scene);
}

void PreviewContent::setViewport(const QSize& pixels) {
  if (pixels == m_viewport) return;
  m_viewport = pixels;
  traceBoth();
  Q_EMIT changed();
}

QSize PreviewContent::pictureSize() const {
  const bool halved = isComparing() && m_comparison.mode == CompareMode::twoUp;
  return halved ? QSize(std::max(1, m_viewport.width() / 2), m_viewport.height()) : m_viewport;
}

bool PreviewContent::isNoisy() const {
  // Light without a size that is reflected once has no noise: its samples smooth the edge alone.
  const rendering::EffectPlan& simulated = m_first.plan();
  return simulated.simulates(rendering::Effect::environmentLight) ||
         simulated.simulates(rendering::Effect::areaLightSampling) || simulated.reflections > 1;
}

int PreviewContent::wantedSamples() const { return isNoisy() ? 512 : 64; }

bool PreviewContent::isBusy() const {
  const auto busy = [this](const PreviewSide& side) {
    return side.isEstimating() || (tracing() != Tracing::never && !side.tracer().isDone());
  };
  return busy(m_first) || (isComparing() && busy(m_second));
}

bool PreviewContent::isWorthShowing(const PreviewSide& side) const {
  const SceneTracer& tracer = side.tracer();
  if (tracing() == Tracing::always) return tracer.film() != nullptr;
  return tracing() == Tracing::atRest && tracer.isCurrent() &&
         QSize(tracer.film()->width, tracer.film()->height) == pictureSize() &&
         tracer.film()->samples >= (m_software ? 1 : minFilmSamples);
}

PictureRequest PreviewContent::request() const {
  PictureRequest::Side first = m_first.request(), second = m_second.request();
  // Both pictures of a comparison come from the same renderer.
  if (isWorthShowing(m_first) && (!isComparing() || isWorthShowing(m_second))) {
    first.film = m_first.tracer().film();
    if (isComparing()) second.film = m_second.tracer().film();
  }
  std::vector<PreviewSubject> otherSlotSubjects;
  for (const SlotMaterial& other : m_otherSlotMaterials) otherSlotSubjects.push_back(other.subject);
  return {.sides = {first, second},
          .scene = m_scene,
          .otherSlotSubjects = otherSlotSubjects,
          .isDrawn = tracing() != Tracing::always,
          .drawsAtRest = !m_software || tracing() == Tracing::never,
          .comparing = isComparing(),
          .comparison = m_comparison,
          .display = {},
          .viewport = m_viewport,
          .picture = pictureSize(),
          .wantedSamples = wantedSamples(),
          .changed = {}};
}

}  // namespace gonio::widgets

#include "moc_preview_content.cpp"
