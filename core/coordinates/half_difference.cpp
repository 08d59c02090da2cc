// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/half_difference.h"

#include <cmath>

#include "core/coordinates/half_difference_block.h"

namespace gonio {

HalfDifference toHalfDifference(const Direction& wi, const Direction& wo) {
  const DirectionPair pair{wi, wo};
  HalfDifferenceBlock block;
  toHalfDifference(std::span(&pair, 1), block);
  return {block.thetaH[0], block.thetaD[0], block.phiD[0], block.valid[0] != 0};
}

DirectionPair fromHalfDifference(double thetaH, double thetaD, double phiD) {
  return fromHalfDifference(std::sin(thetaH), std::cos(thetaH), std::sin(thetaD), std::cos(thetaD), std::sin(phiD),
                            std::cos(phiD));
}

bool isAboveHorizon(double thetaH, double thetaD, double phiD) {
  return isAboveHorizon(std::sin(thetaH), std::cos(thetaH), std::sin(thetaD), std::cos(thetaD), std::cos(phiD));
}

}  // namespace gonio
