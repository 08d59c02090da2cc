// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/sampling_lobe.h"
#include "core/rendering/sphere_scene.h"
#include "core/support/task_control.h"

namespace gonio {

struct SphereRenderOptions {
  int width = 256, height = 256;
  /// Samples a pixel: under an environment each draws one direction from the environment and one from the lobe
  /// (multiple importance sampling, balance heuristic: Veach 1997); edges are antialiased by the same samples.
  int samples = 64;
  std::uint64_t seed = 1;
  /// Density for BRDF samples; estimated from the BRDF when absent. Give the same lobe to pictures that are compared:
  /// with equal seeds they then share their noise.
  std::optional<SamplingLobe> lobe;
};

/// Renders the sphere: linear RGB radiance, double accumulation, the same bits for any number of threads.
/// @throws Cancelled.
Image renderSphere(const Brdf& brdf, const SphereScene& scene, const SphereRenderOptions& options,
                   const TaskControl& control = {});

/// The scene of every rendered SNR in Gonio, named "sphere-studio": the sphere with the default camera in the studio.
SphereScene comparisonScene();
inline constexpr const char* comparisonSceneName = "sphere-studio";

}  // namespace gonio
