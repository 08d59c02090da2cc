// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cmath>

#include "core/math/types.h"

namespace gonio {

/// Rotates directions about the normal, for example to evaluate an anisotropic material at several azimuths.
class AzimuthRotation {
 public:
  /// @param angle rad, counter-clockwise seen from above.
  explicit AzimuthRotation(double angle) : c_(std::cos(angle)), s_(std::sin(angle)), minusS_(-s_) {}

  // Two sums, not a difference and a sum: despite -ffp-contract=off, GCC 12 fuses the latter in some of the functions
  // where it is inlined, and results would differ in the last bit.
  Direction operator()(const Direction& w) const { return {c_ * w.x + minusS_ * w.y, s_ * w.x + c_ * w.y, w.z}; }
  DirectionPair operator()(const DirectionPair& pair) const { return {(*this)(pair.wi), (*this)(pair.wo)}; }

 private:
  double c_, s_, minusS_;
};

}  // namespace gonio
