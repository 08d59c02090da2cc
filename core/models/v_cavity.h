// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/models/surface_geometry.h"

namespace gonio::models {

/// G / (cos theta_i cos theta_o) of the V-cavity masking G = min(1, 2 cos theta_h cos theta_i / cos theta_d,
/// 2 cos theta_h cos theta_o / cos theta_d) (Cook and Torrance, "A Reflectance Model for Computer Graphics",
/// 1982), computed in a form in which the smaller cosine cancels where G is small. O(1).
inline double vCavityOverCosines(const SurfaceGeometry& g) {
  const double unmasked = 1 / (g.cosI * g.cosO);
  const double masked = 2 * g.half.z / (g.cosD * (g.cosI > g.cosO ? g.cosI : g.cosO));
  return unmasked < masked ? unmasked : masked;
}

}  // namespace gonio::models
