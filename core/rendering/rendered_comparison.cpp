// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/rendered_comparison.h"

#include "core/metrics/image_metrics.h"

namespace gonio {

RenderedComparison::RenderedComparison(const Brdf& reference, SphereRenderOptions options, const TaskControl& control)
    : scene_(comparisonScene()), options_(std::move(options)) {
  if (!options_.lobe) options_.lobe = estimateSamplingLobe(reference);
  reference_ = renderSphere(reference, scene_, options_, control);
}

Image RenderedComparison::render(const Brdf& test, const TaskControl& control) const {
  return renderSphere(test, scene_, options_, control);
}

double RenderedComparison::signalToNoiseRatio(const Image& picture) const {
  return metrics::signalToNoiseRatio(reference_, picture);
}

}  // namespace gonio
