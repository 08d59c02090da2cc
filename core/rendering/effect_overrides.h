// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/effect_plan.h"

namespace gonio {

/// Turns the effects of an analysed plan on or off as the user forces them. An effect that is forced on is simulated
/// for every pair of objects and lights; interreflection up to `thresholds.maxReflections`.
void applyOverrides(EffectPlan& plan, std::span<const std::shared_ptr<const RenderMaterial>> materials,
                    const EffectOverrides& overrides, const EffectThresholds& thresholds);

}  // namespace gonio
