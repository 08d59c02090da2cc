// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/plan_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gonio::rendering {

namespace {

constexpr int side = 64, blockSide = 8, samples = 4;

/// A sum of numbers with its standard error.
struct Estimate {
  double sum = 0, squares = 0;
  int count = 0;

  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
  double mean() const { return sum / count; }
  double standardError() const {
    return std::sqrt(std::max(0.0, squares / count - mean() * mean()) / std::max(1, count - 1));
  }
};

Film rendered(const Scene& scene, const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
              const EffectPlan& plan, const TaskControl& control) {
  constexpr std::uint64_t seed = 0x5bd1e995;
  Film film(side, side);
  PathTracer(scene, materials, plan, seed).accumulate(film, samples, {control.stop, {}});
  return film;
}

/// Effects that the plan may have left out although they show; emission toward the camera is decided exactly.
EffectOverrides omittable(EffectOverrides overrides) {
  for (const Effect effect : {Effect::directLight, Effect::environmentLight, Effect::castShadows, Effect::selfShadowing,
                              Effect::interreflection})
    if (!overrides[std::size_t(effect)]) overrides[std::size_t(effect)] = true;
  return overrides;
}

/// Whether an object could show another or itself, so that something may be left out.
bool mayOmit(const Scene& scene, const EffectPlan& plan) {
  std::size_t reflecting = 0;
  bool concave = false;
  for (const SceneObject& object : scene.objects) {
    if (object.emits()) continue;
    ++reflecting;
    concave = concave || !isConvex(object.shape);
  }
  return plan.endsPathsEarly && !plan.lights.empty() && (reflecting > 1 || concave);
}

std::string percentOf(double fraction) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100 * fraction);
  return text;
}

}  // namespace

bool PlanCheck::findsMore(double remainder) const {
  // 64 blocks are looked at, so that the worst must stand out more.
  constexpr double errors = 4, worstErrors = 6;
  return omitted > remainder + errors * standardError || worstBlock > remainder + worstErrors * worstStandardError;
}

PlanCheck checkPlan(const Scene& scene, const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
                    const EffectPlan& plan, const EffectOverrides& overrides, const EffectThresholds& thresholds,
                    const TaskControl& control) {
  const Film all = rendered(scene, materials, planEffects(scene, materials, omittable(overrides), thresholds), control);
  const Film planned = rendered(scene, materials, plan, control);
  constexpr int blocks = side / blockSide;
  Estimate whole;
  std::array<Estimate, std::size_t(blocks * blocks)> parts;
  double brightness = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto pixel = std::size_t(y) * side + std::size_t(x);
      const double missing = maxChannel(all.radiance[pixel] - planned.radiance[pixel]) / samples;
      brightness += maxChannel(all.radiance[pixel]) / samples / (side * side);
      whole.add(missing);
      parts[std::size_t(y / blockSide) * blocks + std::size_t(x / blockSide)].add(missing);
    }
  PlanCheck check;
  if (!(brightness > 0)) return check;
  check.omitted = whole.mean() / brightness;
  check.standardError = whole.standardError() / brightness;
  double worst = 0;
  for (const Estimate& part : parts) {
    const double excess = part.mean() - 6 * part.standardError();
    if (!(excess > worst)) continue;
    worst = excess;
    check.worstBlock = part.mean() / brightness;
    check.worstStandardError = part.standardError() / brightness;
  }
  return check;
}

EffectPlan checkedPlan(const Scene& scene, const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
                       const EffectOverrides& overrides, const EffectThresholds& thresholds,
                       const TaskControl& control) {
  EffectPlan plan = planEffects(scene, materials, overrides, thresholds);
  if (!mayOmit(scene, plan)) return plan;
  const PlanCheck check = checkPlan(scene, materials, plan, overrides, thresholds, control);
  if (!check.findsMore(thresholds.remainder)) return plan;
  // Lights and shadows are decided by geometry alone: what a plan may lack are reflections.
  EffectOverrides deeper = overrides;
  std::optional<bool>& interreflection = deeper[std::size_t(Effect::interreflection)];
  if (!interreflection) interreflection = true;
  EffectPlan extended = planEffects(scene, materials, deeper, thresholds);
  extended.endsPathsEarly = true;
  const bool isLocal = check.worstBlock - 6 * check.worstStandardError > check.omitted;
  const std::string found = "a check with all effects found " + percentOf(isLocal ? check.worstBlock : check.omitted) +
                            " +- " + percentOf(isLocal ? check.worstStandardError : check.standardError) +
                            " of the picture's mean more light" + (isLocal ? " in one block" : "");
  for (std::size_t i = 0; i < effectCount; ++i) {
    EffectDecision& decision = extended.decisions[i];
    if (overrides[i] || !decision.simulated || plan.decisions[i] == decision) continue;
    decision.calledFor = true;
    decision.reason = found + "; without the check: " + plan.decisions[i].reason;
  }
  return extended;
}

}  // namespace gonio::rendering
