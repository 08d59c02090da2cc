// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <mutex>

#include "core/rendering/effect_plan.h"
#include "core/rendering/film.h"
#include "core/support/task_control.h"

namespace gonio::rendering {

/// A path tracer (Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", section 8.2) that simulates
/// only the effects of a plan. At each surface it samples one direction per light and one from the material; for lights
/// that both can find, the power heuristic weights the samples. Before a ray is traced for a path, it may end by
/// Russian roulette, with a probability by what it can still add, compared with the mean brightness of the surfaces in
/// a pilot picture of 1,024 paths; the expectation stays the same. Plans with EffectPlan::endsPathsEarly false follow
/// all paths up to the fourth reflection. Samples are not clamped. Immutable: the sums of a picture are in its Film.
class PathTracer {
 public:
  /// Sampling of lights, materials or both (default). The others exist to compare costs.
  enum class Strategy { both, lights, materials };

  /// @param materials of bindMaterials(), as for the plan.
  PathTracer(Scene scene, std::vector<std::shared_ptr<const RenderMaterial>> materials, EffectPlan plan,
             std::uint64_t seed = 1, Strategy strategy = Strategy::both);

  const Scene& scene() const { return scene_; }
  const EffectPlan& plan() const { return plan_; }

  /// Adds `samples` samples to each pixel. Results are bitwise equal for any number of threads and any division of the
  /// same number of samples into calls. Powers of two are stratified best. @throws Cancelled; the film is then
  /// unchanged.
  void accumulate(Film& film, int samples, const TaskControl& control = {}) const;
  /// Records the paths of a picture, to render other materials with them (RecordedPaths). Preconditions: the plan has
  /// at most one reflection, and the tracer's own material is a placeholder with a BRDF value of 1 everywhere, so that
  /// the recorded weights are the factors of the BRDF value. @param film without samples. @throws Cancelled.
  RecordedPaths record(Film film, int samples, const TaskControl& control = {}) const;

 private:
  class PathBatch;

  /// @param recorded one per row of the film, or none; see PathBatch.
  void trace(Film& film, int samples, std::span<RecordedPaths::Row> recorded, const TaskControl& control) const;
  void traceRow(Film& film, int y, int samples, PathBatch& batch, SampleLuminances& luminances) const;
  std::vector<std::size_t> candidatesOf(std::size_t object) const;
  /// What paths are weighed by, from a pilot picture; the typical radiance is 0 if no path may end early.
  struct Brightness {
    double typical = 0;           ///< radiance of the surfaces in the picture
    std::vector<double> visible;  ///< [object]: light that the brightest object visible from it reflects, the
                                  ///< mean over the pilot's hits; infinite if there are too few
  };
  const Brightness& brightness() const;
  Brightness pilotBrightness() const;

  Scene scene_;
  std::vector<std::shared_ptr<const RenderMaterial>> materials_;
  EffectPlan plan_;
  std::uint64_t seed_;
  Strategy strategy_;
  CameraFrame camera_;
  std::vector<const Brdf*> brdfs_;   ///< of the materials, without duplicates
  std::vector<std::size_t> brdfOf_;  ///< [object]: index into brdfs_
  /// [object]: objects that a direction sampled from its material may hit, as far as the plan simulates them.
  std::vector<std::vector<std::size_t>> candidates_;
  std::vector<bool> sendsRays_;  ///< [object]: whether any ray leaves it
  struct FirstUse {
    std::once_flag once;
    Brightness brightness;
  };
  std::shared_ptr<FirstUse> pilot_ = std::make_shared<FirstUse>();
  std::vector<bool> findsLights_;  ///< [object]: whether directions sampled from its material can hit a light
};

}  // namespace gonio::rendering
