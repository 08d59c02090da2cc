// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/study/gamma_selection.h"

#include <algorithm>

#include "core/rendering/render_picture.h"

namespace gonio::study {

namespace {

constexpr double gammaStep = 0.25;
constexpr int gammaCount = int((metrics::maxGamma - metrics::minGamma) / gammaStep) + 1;

}  // namespace

std::vector<GammaTrial> selectGamma(const fitting::FitBase& base, const models::Model& model,
                                    const fitting::FitOptions& options, const RenderOptions& picture,
                                    const TaskControl& control) {
  std::vector<GammaTrial> trials;
  try {
    const RenderedComparison comparison(*base.measurement, picture, {control.stop, {}});
    for (int i = 0; i < gammaCount; ++i) {
      fitting::FitOptions gammaOptions = options;
      gammaOptions.metric = metrics::BrdfMetric::gamma;
      gammaOptions.gamma = metrics::minGamma + i * gammaStep;
      fitting::FitResult result = fitting::fit(base, model, gammaOptions, {control.stop, {}});
      control.throwIfStopped();
      const ComparisonPicture rendered = comparison.render(*model.instantiate(result.parameters), {control.stop, {}});
      trials.push_back({gammaOptions.gamma, std::move(result), comparison.signalToNoiseRatio(rendered)});
      control.report(double(i + 1) / gammaCount);
    }
  } catch (const Cancelled&) {
  }
  // Comparisons with a NaN (a black reference) are false: the first stays.
  const auto best = std::ranges::max_element(
      trials, [](const GammaTrial& a, const GammaTrial& b) { return a.renderedSnr < b.renderedSnr; });
  if (best != trials.end()) std::rotate(trials.begin(), best, best + 1);
  return trials;
}

}  // namespace gonio::study
