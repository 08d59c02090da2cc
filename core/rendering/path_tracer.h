// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/effect_plan.h"
#include "core/rendering/film.h"
#include "core/support/task_control.h"

namespace gonio {

/// The renderer: the integral over light paths (Veach 1997, section 8.2; Tongbuasirilai 2023, section 2.1) by random
/// walks from the eye, with only the effects of a plan. At each surface one direction is sampled from each light and
/// one from the material; where both find the same light, the power heuristic weights them. From the fourth reflection
/// on, paths that carry little end by Russian roulette. No sample is clamped. Immutable: a picture's sums are in its
/// Film.
class PathTracer {
 public:
  /// Light is sampled from both sides by default; from one alone to show what each costs.
  enum class Strategy { both, lights, materials };

  /// @param materials of bindMaterials(), of which the plan was made.
  PathTracer(Scene scene, std::vector<std::shared_ptr<const RenderMaterial>> materials, EffectPlan plan,
             std::uint64_t seed = 1, Strategy strategy = Strategy::both);

  const Scene& scene() const { return scene_; }
  const EffectPlan& plan() const { return plan_; }

  /// Adds `samples` more to each pixel. The same bits for any number of threads, and for the same count in one part or
  /// several. Powers of two are best stratified.
  /// @throws Cancelled; the film is then as it was.
  void accumulate(Film& film, int samples, const TaskControl& control = {}) const;

 private:
  class PathBatch;

  void traceRow(Film& film, int y, int samples, RayCounters& counters, SampleLuminances& luminances) const;
  std::vector<std::size_t> candidatesOf(std::size_t object) const;

  Scene scene_;
  std::vector<std::shared_ptr<const RenderMaterial>> materials_;
  EffectPlan plan_;
  std::uint64_t seed_;
  Strategy strategy_;
  CameraFrame camera_;
  std::vector<const Brdf*> brdfs_;   ///< of the materials, each once
  std::vector<std::size_t> brdfOf_;  ///< [object]: among brdfs_
  /// [object]: what a direction sampled from its material may meet that counts.
  std::vector<std::vector<std::size_t>> candidates_;
  std::vector<bool> sendsRays_;    ///< [object]: whether any ray leaves it
  std::vector<bool> findsLights_;  ///< [object]: whether directions sampled from its material can find a light
};

}  // namespace gonio
