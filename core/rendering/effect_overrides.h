// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/effect_plan.h"

namespace gonio {

/// Switches the effects of an analysed plan as the user requests. An effect that is forced on is simulated for all
/// pairs of objects and lights; interreflection up to `thresholds.maxReflections`.
void applyOverrides(EffectPlan& plan, std::span<const std::shared_ptr<const RenderMaterial>> materials,
                    const EffectOverrides& overrides, const EffectThresholds& thresholds);

}  // namespace gonio
