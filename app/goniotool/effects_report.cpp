// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/effects_report.h"

namespace gonio::tool {

Json planJson(const EffectPlan& plan, const EffectCosts* costs) {
  Json list = Json::array();
  for (std::size_t i = 0; i < effectCount; ++i) {
    const EffectDecision& decision = plan.decisions[i];
    Json one{{"effect", effectId(Effect(i))},
             {"simulated", decision.simulated},
             {"calledFor", decision.calledFor},
             {"reason", decision.reason}};
    if (costs) {
      const EffectCost& cost = costs->effects[i];
      one["seconds"] = cost.seconds;
      one["secondsNoise"] = cost.secondsNoise;
      one["difference"] = cost.difference;
      one["noise"] = cost.noise;
    }
    list.push_back(std::move(one));
  }
  return list;
}

std::string timeText(const EffectCost& cost) {
  const std::string time = number(cost.seconds) + " +- " + number(cost.secondsNoise) + " s";
  return cost.isWithinNoise() ? time + " (within noise)" : time;
}

std::string planText(const EffectPlan& plan, const EffectCosts* costs) {
  std::string text;
  for (std::size_t i = 0; i < effectCount; ++i) {
    const EffectDecision& decision = plan.decisions[i];
    text += std::string("  ") + effectId(Effect(i)) + ": " + (decision.simulated ? "yes" : "no");
    if (decision.simulated != decision.calledFor) text += " (forced)";
    text += ", " + decision.reason;
    if (costs)
      text += "; " + timeText(costs->effects[i]) + ", changes the image by " +
              number(100 * costs->effects[i].difference) + " % (noise " + number(100 * costs->effects[i].noise) + " %)";
    text += "\n";
  }
  return text;
}

}  // namespace gonio::tool
