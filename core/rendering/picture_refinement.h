// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <limits>

#include "core/rendering/path_tracer.h"
#include "core/support/task_control.h"

namespace gonio::rendering {

/// Limits of a picture; it is complete when the first one is reached.
struct RefinementLimits {
  int samples = 256;                                         ///< per pixel
  double seconds = std::numeric_limits<double>::infinity();  ///< rendering time without pauses
};

/// Adds samples to a film, in passes of at most 16, until a limit is reached; at least one sample. The time limit may
/// be exceeded by one pass of one sample. A pause takes effect between passes. @throws Cancelled.
void refinePicture(const PathTracer& tracer, Film& film, const RefinementLimits& limits,
                   const TaskControl& control = {}, const Pause* pause = nullptr);

/// Estimated cost of a picture, from a small picture of the same scene.
struct PictureEstimate {
  double secondsPerSample = 0;  ///< time to add one sample to every pixel
  double noisePerSample = 0;    ///< RMS noise over the pixels relative to the mean radiance, extrapolated to one sample
                                ///< per pixel
  double order = 0.5;           ///< noise decreases as samples^-order: 1/2 for random samples, more with effective
                                ///< stratification

  double seconds(int samples) const { return secondsPerSample * samples; }
  double noise(int samples) const;
};

/// Renders two pictures of about 4,000 pixels and compares them after 4 and 16 samples; a few tenths of a second.
/// @param width, height of the picture to estimate. @throws Cancelled.
PictureEstimate estimatePicture(const Scene& scene, const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
                                const EffectPlan& plan, int width, int height, const TaskControl& control = {});

}  // namespace gonio::rendering
