// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

#include "core/math/types.h"

namespace gonio {

/// Turns directions about the normal: how the azimuths of an anisotropic material are gone through.
class AzimuthRotation {
 public:
  /// @param angle rad, counter-clockwise seen from above.
  explicit AzimuthRotation(double angle) : c_(std::cos(angle)), s_(std::sin(angle)), minusS_(-s_) {}

  // Two sums rather than a difference and a sum: of the latter GCC 12 makes a fused instruction in some of the places
  // that it is inlined to, in spite of -ffp-contract=off, and the same direction would get different bits.
  Direction operator()(const Direction& w) const { return {c_ * w.x + minusS_ * w.y, s_ * w.x + c_ * w.y, w.z}; }
  DirectionPair operator()(const DirectionPair& pair) const { return {(*this)(pair.wi), (*this)(pair.wo)}; }

 private:
  double c_, s_, minusS_;
};

}  // namespace gonio
