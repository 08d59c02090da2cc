// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/effect_overrides.h"

#include <algorithm>
#include <limits>

namespace gonio {

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
  plan.reflections = maxReflections;
  for (std::size_t object = 0; object < materials.size(); ++object)
    for (std::size_t other = 0; other < materials.size() && materials[object]; ++other)
      if (materials[other]) plan.visible[object].push_back(other);
}

}  // namespace

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

}  // namespace gonio
