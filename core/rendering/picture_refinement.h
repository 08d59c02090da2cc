// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <limits>

#include "core/rendering/path_tracer.h"
#include "core/support/pause.h"

namespace gonio {

/// When a picture is done: at the first of the two.
struct RefinementLimits {
  int samples = 256;                                         ///< of each pixel
  double seconds = std::numeric_limits<double>::infinity();  ///< of work, pauses not counted
};

/// Adds samples to a film, in passes of at most 16, until a limit is reached; at least one. A limit of time is kept to
/// within a pass of one sample. A pause takes effect between passes.
/// @throws Cancelled.
void refinePicture(const PathTracer& tracer, Film& film, const RefinementLimits& limits,
                   const TaskControl& control = {}, const Pause* pause = nullptr);

/// What a picture costs, from a small one of the same scene.
struct PictureEstimate {
  double secondsOfSample = 0;  ///< of one sample of each pixel of the picture
  double noiseOfSample = 0;    ///< relative to the mean radiance, RMS over the pixels, extrapolated to one sample each
  double order = 0.5;          ///< noise falls as samples^-order: 1/2 at random, more where strata help

  double seconds(int samples) const { return secondsOfSample * samples; }
  double noise(int samples) const;
};

/// Traces two pictures of about 4,000 pixels, looked at with 4 and with 16 samples: some tenths of a second.
/// @param width, height of the picture that is to be estimated. @throws Cancelled.
PictureEstimate estimatePicture(const Scene& scene, const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
                                const EffectPlan& plan, int width, int height, const TaskControl& control = {});

}  // namespace gonio
