// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/goniotool/report.h"
#include "core/rendering/effect_costs.h"

/// Reports of effect plans.
namespace gonio::tool {

/// [{effect, simulated, calledFor, reason}]; `calledFor` is whether the analysis requires the effect, without
/// overrides. With measured costs also seconds, secondsNoise, difference and noise.
Json planJson(const EffectPlan& plan, const EffectCosts* costs = nullptr);
/// One line per effect.
std::string planText(const EffectPlan& plan, const EffectCosts* costs = nullptr);

}  // namespace gonio::tool
