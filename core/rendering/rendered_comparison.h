// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/rendering/sphere_renderer.h"

namespace gonio {

/// Pictures of materials in comparisonScene() against that of one reference, which is rendered once. All use its lobe
/// and seed: they share their noise, so the SNR is that of the materials.
class RenderedComparison {
 public:
  /// Renders the reference. @throws Cancelled.
  explicit RenderedComparison(const Brdf& reference, SphereRenderOptions options = {}, const TaskControl& control = {});

  const Image& reference() const { return reference_; }
  /// @throws Cancelled.
  Image render(const Brdf& test, const TaskControl& control = {}) const;
  /// Of a picture by render(), dB; contract for 0 as metrics::signalToNoiseRatio.
  double signalToNoiseRatio(const Image& picture) const;

 private:
  SphereScene scene_;
  SphereRenderOptions options_;
  Image reference_;
};

}  // namespace gonio
