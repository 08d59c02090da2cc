// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/effect_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/support/error.h"

namespace gonio::rendering {

namespace {

using Materials = std::span<const std::shared_ptr<const RenderMaterial>>;

void forceLights(EffectPlan& plan, Materials materials, const EffectOverrides& overrides) {
  for (std::size_t object = 0; object < plan.lit.size(); ++object)
    for (std::size_t light = 0; light < plan.lights.size(); ++light) {
      const bool distant = plan.lights[light].kind == SceneLight::Kind::environment;
      const auto on = overrides[std::size_t(distant ? Effect::environmentLight : Effect::directLight)];
      if (!on) continue;
      plan.lit[object][light] = *on && materials[object];
      if (plan.lit[object][light]) plan.reflections = std::max(plan.reflections, 1);
    }
}

/// @param self of self-shadowing: the object itself; else all others.
void forceBlockers(EffectPlan& plan, bool on, bool self) {
  const std::size_t count = plan.blockers.size();
  for (std::size_t object = 0; object < count; ++object)
    for (std::size_t light = 0; light < plan.lights.size(); ++light) {
      std::vector<std::size_t>& blockers = plan.blockers[object][light];
      std::erase_if(blockers, [&](std::size_t blocker) { return (blocker == object) == self; });
      const SceneLight& source = plan.lights[light];
      for (std::size_t blocker = 0; on && blocker < count; ++blocker)
        if ((blocker == object) == self && !(source.kind == SceneLight::Kind::rectangle && source.index == blocker))
          blockers.push_back(blocker);
    }
}

void forceInterreflection(EffectPlan& plan, bool on, int maxReflections, Materials materials) {
  for (auto& visible : plan.visible) visible.clear();
  if (!on && plan.reflections > 1) plan.remainder = std::numeric_limits<double>::infinity();
  plan.reflections = std::min(plan.reflections, 1);
  if (!on || plan.reflections == 0) return;
  plan.endsPathsEarly = false;
  plan.reflections = maxReflections;
  for (std::size_t object = 0; object < materials.size(); ++object)
    for (std::size_t other = 0; other < materials.size() && materials[object]; ++other)
      if (materials[other]) plan.visible[object].push_back(other);
}

/// Switches the effects of an analysed plan as the user requests. An effect that is forced on is simulated for all
/// pairs of objects and lights; interreflection up to `thresholds.maxReflections`.
void applyOverrides(EffectPlan& plan, Materials materials, const EffectOverrides& overrides,
                    const EffectThresholds& thresholds) {
  const auto forced = [&](Effect effect) { return overrides[std::size_t(effect)]; };
  for (std::size_t i = 0; i < effectCount; ++i)
    if (overrides[i]) plan.decisions[i].simulated = *overrides[i];
  forceLights(plan, materials, overrides);
  if (const auto on = forced(Effect::castShadows)) forceBlockers(plan, *on, false);
  if (const auto on = forced(Effect::selfShadowing)) forceBlockers(plan, *on, true);
  if (const auto on = forced(Effect::interreflection))
    forceInterreflection(plan, *on, thresholds.maxReflections, materials);
}

using Materials = std::span<const std::shared_ptr<const RenderMaterial>>;

constexpr std::array<const char*, effectCount> ids{"emitted-light",      "direct-light",       "environment-light",
                                                   "cast-shadows",       "self-shadowing",     "interreflection",
                                                   "anisotropic-frames", "area-light-sampling"};

/// Two significant digits of a percentage.
std::string percent(double fraction) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100 * fraction);
  return text;
}

std::string ordinal(int number) {
  const int ten = number / 10 % 10, one = number % 10;
  return std::to_string(number) + (ten == 1 || one < 1 || one > 3 ? "th" : one == 1 ? "st" : one == 2 ? "nd" : "rd");
}

/// Light that reaches the eye from its source.
EffectDecision emittedLightDecision(const Scene& scene) {
  if (scene.showEnvironment && scene.environment) return {true, true, "the environment is shown behind the objects"};
  const CameraFrame camera = cameraFrame(scene.camera);
  for (const SceneObject& object : scene.objects) {
    if (!object.emits()) continue;
    const auto& lamp = std::get<Rectangle>(object.shape);
    const Direction toEye = camera.orthographic ? -camera.forward : camera.eye - lamp.centre;
    if (glm::dot(lamp.normal(), toEye) > 0 &&
        support(object.shape, camera.forward) > glm::dot(camera.eye, camera.forward))
      return {true, true, "the front of " + object.name + " faces the camera"};
  }
  return {false, false, "no area light faces the camera"};
}

/// Fills in the facts of a scene and decides; forces come after it.
class Analysis {
 public:
  Analysis(const Scene& scene, Materials materials, const EffectThresholds& thresholds)
      : scene_(scene), materials_(materials), thresholds_(thresholds) {
    plan.lights = lightsOf(scene);
    findLit();
    findBlockers();
    findVisible();
    decideLights();
    decideShadows();
    decideInterreflection();
    decideFrames();
  }

  /// The reflections after which all others add less than the threshold, at most `maxReflections`; and what they add.
  std::pair<int, double> depth(const std::vector<std::vector<std::size_t>>& visible) const;

  EffectPlan plan;

 private:
  void findLit();
  void findBlockers();
  void findVisible();
  void decideLights();
  void decideShadows();
  void decideInterreflection();
  void decideFrames();
  std::string materialWithoutBound() const;
  void decide(Effect effect, bool calledFor, std::string reason) {
    plan.decisions[std::size_t(effect)] = {calledFor, calledFor, std::move(reason)};
  }
  bool reflects(std::size_t object) const { return materials_[object] && !materials_[object]->isBlack(); }
  bool isLit(std::size_t object) const { return std::ranges::find(plan.lit[object], true) != plan.lit[object].end(); }

  const Scene& scene_;
  Materials materials_;
  const EffectThresholds& thresholds_;
};

void Analysis::findLit() {
  for (std::size_t object = 0; object < scene_.objects.size(); ++object) {
    std::vector<bool>& lit = plan.lit.emplace_back();
    for (const SceneLight& light : plan.lights)
      lit.push_back(reflects(object) && canReach(scene_, light, scene_.objects[object]));
  }
}

void Analysis::findBlockers() {
  const std::size_t count = scene_.objects.size();
  plan.blockers.assign(count, std::vector<std::vector<std::size_t>>(plan.lights.size()));
  for (std::size_t object = 0; object < count; ++object)
    for (std::size_t light = 0; light < plan.lights.size(); ++light)
      for (std::size_t blocker = 0; blocker < count && plan.lit[object][light]; ++blocker)
        if (mayBlock(scene_, plan.lights[light], scene_.objects[object], scene_.objects[blocker]))
          plan.blockers[object][light].push_back(blocker);
}

void Analysis::findVisible() {
  plan.visible.resize(scene_.objects.size());
  for (std::size_t object = 0; object < scene_.objects.size(); ++object)
    for (std::size_t other = 0; other < scene_.objects.size() && reflects(object); ++other)
      if (reflects(other) && maySee(scene_.objects[object], scene_.objects[other]))
        plan.visible[object].push_back(other);
}

void Analysis::decideLights() {
  plan.decisions[std::size_t(Effect::emittedLight)] = emittedLightDecision(scene_);
  std::string direct, surrounding;
  bool haveLights = false, haveSize = false;
  for (std::size_t light = 0; light < plan.lights.size(); ++light) {
    const SceneLight& source = plan.lights[light];
    const bool isEnvironment = source.kind == SceneLight::Kind::environment;
    haveLights = haveLights || !isEnvironment;
    for (std::size_t object = 0; object < scene_.objects.size(); ++object) {
      if (!plan.lit[object][light]) continue;
      haveSize = haveSize || source.kind == SceneLight::Kind::rectangle;
      std::string& reason = isEnvironment ? surrounding : direct;
      if (reason.empty()) reason = lightName(scene_, source) + " lights " + scene_.objects[object].name;
    }
  }
  decide(Effect::directLight, !direct.empty(),
         !direct.empty() ? direct
         : haveLights    ? "no reflecting surface faces a distant, point or area light"
                         : "there is no distant, point or area light");
  decide(Effect::environmentLight, !surrounding.empty(),
         !surrounding.empty()  ? surrounding
         : !scene_.environment ? "there is no environment"
                               : "the environment is black, or nothing reflects it");
  decide(Effect::areaLightSampling, haveSize,
         haveSize ? "an area light illuminates a surface" : "no area light illuminates a surface");
}

void Analysis::decideShadows() {
  std::string cast, self;
  std::size_t occlusions = 0;
  for (std::size_t object = 0; object < scene_.objects.size(); ++object)
    for (std::size_t light = 0; light < plan.lights.size(); ++light)
      for (const std::size_t blocker : plan.blockers[object][light]) {
        if (blocker == object) {
          if (self.empty()) self = scene_.objects[object].name + " is not convex";
          continue;
        }
        if (++occlusions == 1)
          cast = scene_.objects[blocker].name + " may occlude " + lightName(scene_, plan.lights[light]) + " from " +
                 scene_.objects[object].name;
      }
  if (occlusions > 1) cast += ", and " + std::to_string(occlusions - 1) + " more";
  decide(Effect::castShadows, occlusions > 0, occlusions > 0 ? cast : "nothing occludes a light from a surface");
  decide(Effect::selfShadowing, !self.empty(), self.empty() ? "every lit shape is convex" : self);
}

std::pair<int, double> Analysis::depth(const std::vector<std::vector<std::size_t>>& visible) const {
  const std::size_t count = scene_.objects.size();
  // [i][j]: the fraction of the light from visible[i][j] that object i reflects.
  std::vector<std::vector<double>> reflected(count);
  for (std::size_t i = 0; i < count; ++i)
    for (const std::size_t j : visible[i])
      reflected[i].push_back(materials_[i]->bound().at(maxFormFactor(scene_.objects[i], scene_.objects[j])));
  // bound[i]: what leaves object i after so many reflections, as a fraction of the brightest first one.
  std::vector<double> bound(count, 1), additions;
  constexpr int horizon = 4096;
  while (additions.size() < horizon) {
    std::vector<double> next(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      double sum = 0, largest = 0;
      for (std::size_t k = 0; k < visible[i].size(); ++k) {
        sum += reflected[i][k] * bound[visible[i][k]];
        largest = std::max(largest, bound[visible[i][k]]);
      }
      if (largest > 0) next[i] = std::min(sum, materials_[i]->bound().maxAlbedo() * largest);
    }
    bound = next;
    additions.push_back(count > 0 ? *std::ranges::max_element(bound) : 0);
    if (!(additions.back() > 1e-9) || additions.back() > 1e9) break;
  }
  // A bound that does not fall says nothing about the rest.
  if (additions.back() > 1e-6) return {thresholds_.maxReflections, std::numeric_limits<double>::infinity()};
  double remainder = 0;
  std::size_t reflections = additions.size() + 1;
  for (std::size_t k = additions.size(); k-- > 0; --reflections) {
    if (remainder + additions[k] > thresholds_.remainder) break;
    remainder += additions[k];
  }
  const std::size_t most = std::size_t(thresholds_.maxReflections);
  for (; reflections > most; --reflections) remainder += additions[reflections - 2];
  return {int(reflections), remainder};
}

void Analysis::decideInterreflection() {
  std::string pair;
  for (std::size_t object = 0; object < scene_.objects.size() && pair.empty(); ++object)
    if (!plan.visible[object].empty()) {
      const std::size_t other = plan.visible[object].front();
      pair = other == object ? "parts of " + scene_.objects[object].name + " are visible from each other"
                             : scene_.objects[other].name + " is visible from " + scene_.objects[object].name;
    }
  const auto lit = [&](std::size_t object) { return isLit(object); };
  bool anyLit = false;
  for (std::size_t object = 0; object < scene_.objects.size(); ++object) anyLit = anyLit || lit(object);
  plan.reflections = anyLit ? 1 : 0;
  if (!anyLit) return decide(Effect::interreflection, false, "no light falls on a reflecting surface");
  if (pair.empty()) return decide(Effect::interreflection, false, "no reflecting surface is visible from another");
  std::tie(plan.reflections, plan.remainder) = depth(plan.visible);
  const std::string limit = "limited to " + std::to_string(plan.reflections);
  if (!std::isfinite(plan.remainder)) {
    const std::string unbounded = materialWithoutBound();
    const std::string why = unbounded.empty() ? "reflections do not die out; "
                                              : "no bound is known for the material of " + unbounded + "; ";
    return decide(Effect::interreflection, plan.reflections > 1, pair + "; " + why + limit);
  }
  const std::string least = percent(plan.remainder) + " of the brightest first reflection";
  if (plan.reflections == 1)
    return decide(Effect::interreflection, false, pair + ", but further reflections add at most " + least);
  decide(Effect::interreflection, true,
         pair + "; reflections after the " + ordinal(plan.reflections) + " add at most " + least);
}

std::string Analysis::materialWithoutBound() const {
  for (std::size_t object = 0; object < scene_.objects.size(); ++object)
    if (!plan.visible[object].empty() && !materials_[object]->bound().isFinite()) return scene_.objects[object].name;
  return {};
}

void Analysis::decideFrames() {
  for (std::size_t object = 0; object < scene_.objects.size(); ++object)
    if (materials_[object] && !materials_[object]->brdf().isIsotropic())
      return decide(Effect::anisotropicFrames, true,
                    "the material of " + scene_.objects[object].name + " is anisotropic");
  decide(Effect::anisotropicFrames, false, "every material is isotropic");
}

}  // namespace

const char* effectId(Effect effect) { return ids[std::size_t(effect)]; }

Effect effectOfId(const std::string& id) {
  std::string known;
  for (std::size_t i = 0; i < effectCount; ++i) {
    if (id == ids[i]) return Effect(i);
    known += std::string(i ? ", " : "") + ids[i];
  }
  throw Error("found the effect '" + id + "', expected one of " + known);
}

EffectPlan planEffects(const Scene& scene, Materials materials, const EffectOverrides& overrides,
                       const EffectThresholds& thresholds) {
  EffectPlan plan = Analysis(scene, materials, thresholds).plan;
  applyOverrides(plan, materials, overrides, thresholds);
  return plan;
}

void updateForCamera(EffectPlan& plan, const Scene& scene, const EffectOverrides& overrides) {
  EffectDecision& decision = plan.decisions[std::size_t(Effect::emittedLight)];
  decision = emittedLightDecision(scene);
  decision.simulated = overrides[std::size_t(Effect::emittedLight)].value_or(decision.calledFor);
}

std::map<std::string, std::string> pictureAttributes(const Scene& scene, const EffectPlan& plan,
                                                     const std::string& material, int samples, std::uint64_t seed) {
  std::string effects;
  for (std::size_t i = 0; i < effectCount; ++i)
    if (plan.decisions[i].simulated) effects += (effects.empty() ? "" : ", ") + std::string(effectId(Effect(i)));
  return {{"samples", std::to_string(samples)},
          {"scene", scene.name},
          {"effects", effects},
          {"reflections", std::to_string(plan.reflections)},
          {"material", material},
          {"seed", std::to_string(seed)}};
}

EffectOverrides everyEffect() {
  EffectOverrides all;
  all.fill(true);
  return all;
}

}  // namespace gonio::rendering
