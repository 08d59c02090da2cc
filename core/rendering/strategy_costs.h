// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/path_tracer.h"

namespace gonio::rendering {

/// Time and error of a sampling strategy against a converged reference.
struct StrategyCost {
  PathTracer::Strategy strategy;
  double seconds = 0;         ///< rendering time of the picture
  double error = 0;           ///< RMS difference from the reference, relative to the RMS of the reference
  double equalTimeError = 0;  ///< estimated error in the time of `both`: error sqrt(seconds / seconds of `both`)
  double equalErrorTime = 0;  ///< estimated time to the error of `both`: seconds (error / error of `both`)^2
};

struct StrategyCostOptions {
  int width = 128, height = 128, samples = 16;
  int referenceSamples = 1024;
};

/// The id: "both", "lights" or "materials".
const char* strategyId(PathTracer::Strategy strategy);

/// Renders the scene with each strategy, and the reference with `both` and another seed: four pictures. The values at
/// equal time and equal error assume that the error decreases with the square root of the number of samples.
/// @param materials of bindMaterials(), as for the plan.
/// @throws Cancelled.
std::vector<StrategyCost> measureStrategyCosts(const Scene& scene,
                                               const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
                                               const EffectPlan& plan, const StrategyCostOptions& options = {},
                                               const TaskControl& control = {});

}  // namespace gonio::rendering
