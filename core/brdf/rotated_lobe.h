// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/direction_sample.h"
#include "core/coordinates/azimuth_rotation.h"

namespace gonio {

/// A lobe (core/brdf/lobe_mixture.h) rotated about the normal.
template <typename Lobe>
class RotatedLobe {
 public:
  /// @param rotation angle of the lobe's x axis from the tangent, rad, counter-clockwise seen from above.
  RotatedLobe(Lobe lobe, double rotation) : lobe_(lobe), toGrain_(-rotation), fromGrain_(rotation) {}

  Direction sample(const Direction& wo, const glm::dvec2& u) const { return fromGrain_(lobe_.sample(toGrain_(wo), u)); }
  double density(const Direction& w, const Direction& wo) const { return lobe_.density(toGrain_(w), toGrain_(wo)); }

 private:
  Lobe lobe_;
  AzimuthRotation toGrain_, fromGrain_;
};

}  // namespace gonio
