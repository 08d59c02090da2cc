// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/direction_sample.h"

namespace gonio {

/// A lobe (core/brdf/lobe_mixture.h): the viewer reflected about normals of the GGX distribution as the viewer sees
/// them. Heitz 2018, "Sampling the GGX Distribution of Visible Normals".
struct VisibleNormalLobe {
  double alpha;

  Direction sample(const Direction& wo, const glm::dvec2& u) const;
  /// D(h) G1(wo) / (4 cos theta_o), without a division by the cosine.
  double density(const Direction& w, const Direction& wo) const;
};

}  // namespace gonio
