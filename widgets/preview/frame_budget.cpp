// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/frame_budget.h"

#include <algorithm>

namespace gonio::widgets {

FrameBudget::Frame FrameBudget::next(double pixels, int accumulated, int wanted, bool resting) const {
  const double budget = (resting ? restingMs : interactiveMs) * 1e6;
  const auto affordable = [&](double atPixels) {
    return std::clamp(static_cast<int>(budget / std::max(1.0, nsPerSample_ * atPixels)), 1, maxSamplesPerFrame);
  };
  const int full = affordable(pixels);
  if (accumulated == 0 && !resting && full < minFirstSamples) {
    const double scale = nsPerSample_ * pixels / 4 > maxFirstFrameMs * 1e6 ? 0.25 : 0.5;
    return {affordable(pixels * scale * scale), scale};
  }
  return {std::min(full, std::max(1, wanted - accumulated)), 1.0};
}

void FrameBudget::record(double pixels, int samples, double milliseconds) {
  const double measured = milliseconds * 1e6 / std::max(1.0, pixels * samples);
  // One slow frame (a page fault, another program) must not starve the next ones: move half way.
  nsPerSample_ = 0.5 * (nsPerSample_ + measured);
}

}  // namespace gonio::widgets
