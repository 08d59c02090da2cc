// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

#include "core/rendering/path_tracer.h"

namespace gonio {

/// A picture with one effect as its plan has it, against the picture with it the other way round.
struct EffectCost {
  Effect effect;
  double seconds = 0;       ///< what the effect adds to the picture's time, as it was measured
  double secondsNoise = 0;  ///< by how much that is uncertain: both pictures' spreads, see EffectCostOptions::repeats
  double difference = 0;    ///< RMS of the two pictures' difference over the RMS of the picture
  double noise = 0;         ///< the same of two pictures of different seeds: what chance alone differs by

  /// Whether the time is within its noise: the effect may cost this much or nothing.
  bool isWithinNoise() const { return std::abs(seconds) <= secondsNoise; }
};

struct EffectCostOptions {
  int width = 128, height = 128, samples = 16;
  /// Of each picture: the shortest time counts, what lies between it and the median is its spread.
  int repeats = 3;
  EffectThresholds thresholds;
};

struct EffectCosts {
  double seconds = 0;  ///< of the picture as planned
  std::vector<EffectCost> effects;
};

/// Measures each effect by rendering with it on and off: (1 + effectCount) x repeats pictures and one more. Effects
/// that cannot act (no light of the kind) cost what the timer's noise says.
/// @param materials of bindMaterials().
/// @throws Cancelled.
EffectCosts measureEffectCosts(const Scene& scene, const std::vector<std::shared_ptr<const RenderMaterial>>& materials,
                               const EffectOverrides& overrides = {}, const EffectCostOptions& options = {},
                               const TaskControl& control = {});

}  // namespace gonio
