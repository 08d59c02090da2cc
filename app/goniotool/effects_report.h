// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/goniotool/report.h"
#include "core/rendering/effect_costs.h"

/// How plans of effects are reported.
namespace gonio::tool {

/// [{effect, simulated, calledFor, reason}], with the measured costs where there are some: seconds, difference, noise.
Json planJson(const EffectPlan& plan, const EffectCosts* costs = nullptr);
/// A line for each effect.
std::string planText(const EffectPlan& plan, const EffectCosts* costs = nullptr);

}  // namespace gonio::tool
