// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/parameters/linked_channels.h"

#include <algorithm>

namespace gonio::widgets {

double linkedValue(const models::ParameterSpec& spec, const Rgb& channels) {
  // Equal channels are their own mean, without the rounding of the weights.
  if (channels.x == channels.y && channels.y == channels.z) return channels.x;
  return spec.hardMin >= 0 ? luminance(channels) : (channels.x + channels.y + channels.z) / 3;
}

Rgb withLinkedValue(const models::ParameterSpec& spec, const Rgb& channels, double target) {
  const double current = linkedValue(spec, channels);
  if (target == current) return channels;
  const bool scales = spec.hardMin >= 0 && current > 0;
  const bool grey = channels.x == channels.y && channels.y == channels.z;
  Rgb result = grey ? Rgb(target) : scales ? channels * (target / current) : channels + (target - current);
  for (int c = 0; c < 3; ++c) result[c] = std::clamp(result[c], spec.hardMin, spec.hardMax);
  return result;
}

bool isColour(const models::ParameterSpec& spec) {
  return spec.perChannel && spec.choices.empty() && spec.hardMin == 0 && spec.scale == models::ParameterScale::linear &&
         (spec.linear || spec.softMax == 1);
}

}  // namespace gonio::widgets
