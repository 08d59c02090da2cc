// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/path_tracer.h"

namespace gonio {

/// What a sampling strategy reaches in which time, against a converged reference.
struct StrategyCost {
  PathTracer::Strategy strategy;
  double seconds = 0;         ///< of the picture
  double error = 0;           ///< RMS of its difference from the reference, over the RMS of the reference
  double equalTimeError = 0;  ///< the error in the time that `both` takes: error sqrt(seconds / its seconds)
  double equalErrorTime = 0;  ///< seconds to the error that `both` has: seconds (error / its error)^2
};

struct StrategyCostOptions {
  int width = 128, height = 128, samples = 16;
  int referenceSamples = 1024;
};

/// "both", "lights", "materials".
const char* strategyId(PathTracer::Strategy strategy);

/// Renders the scene by each strategy and the reference by `both`, with another seed. The error of independent samples
/// falls with the root of their number, which the figures at equal time and equal error rest on. One reference and
/// three pictures.
/// @param materials of bindMaterials(), of which the plan was made.
/// @throws Cancelled.
std::vector<StrategyCost> measureStrategyCosts(const Scene& scene,
                                               const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
                                               const EffectPlan& plan, const StrategyCostOptions& options = {},
                                               const TaskControl& control = {});

}  // namespace gonio
