// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

#include "core/rendering/path_tracer.h"

namespace gonio::rendering {

/// Comparison of the planned picture with a picture in which one effect is switched off if it is planned, else on.
struct EffectCost {
  Effect effect;
  double seconds = 0;       ///< measured rendering time that the effect adds
  double secondsNoise = 0;  ///< its uncertainty: the spreads of both pictures, see EffectCostOptions::repeats
  double difference = 0;    ///< RMS of the difference of both pictures, relative to the RMS of the planned picture
  double noise = 0;         ///< the same for two pictures with different seeds: the part due to noise

  /// Whether the time is within its uncertainty, so that the effect may cost nothing.
  bool isWithinNoise() const { return std::abs(seconds) <= secondsNoise; }
};

struct EffectCostOptions {
  int width = 128, height = 128, samples = 16;
  /// Renderings per picture: the shortest time is used, and its difference from the median is the spread.
  int repeats = 3;
  EffectThresholds thresholds;
};

struct EffectCosts {
  double seconds = 0;  ///< time of the planned picture
  std::vector<EffectCost> effects;
};

/// Measures each effect by rendering with it on and off: (1 + effectCount) x repeats + 1 pictures. Effects without
/// influence (such as a missing kind of light) only show the noise of the timer.
/// @param materials of bindMaterials().
/// @throws Cancelled.
EffectCosts measureEffectCosts(const Scene& scene, const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
                               const EffectOverrides& overrides = {}, const EffectCostOptions& options = {},
                               const TaskControl& control = {});

}  // namespace gonio::rendering
