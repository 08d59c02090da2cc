// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/coordinates/half_difference.h"

#include <cassert>
#include <cmath>

#include "core/math/fast_functions.h"

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

namespace {

constexpr double minSquaredPoleRadius = 1e-24;
constexpr double minSquaredDifference = 1e-24;

/// Components of wi + wo and of wi - wo.
struct SumsAndDifferences {
  double sx[HalfDifferenceBlock::capacity], sy[HalfDifferenceBlock::capacity], sz[HalfDifferenceBlock::capacity];
  double dx[HalfDifferenceBlock::capacity], dy[HalfDifferenceBlock::capacity], dz[HalfDifferenceBlock::capacity];
};

}  // namespace

void toHalfDifference(std::span<const DirectionPair> pairs, HalfDifferenceBlock& block) {
  assert(pairs.size() <= HalfDifferenceBlock::capacity);
  SumsAndDifferences v;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [wi, wo] = pairs[i];
    v.sx[i] = wi.x + wo.x;
    v.sy[i] = wi.y + wo.y;
    v.sz[i] = wi.z + wo.z;
    v.dx[i] = wi.x - wo.x;
    v.dy[i] = wi.y - wo.y;
    v.dz[i] = wi.z - wo.z;
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double sx = v.sx[i], sy = v.sy[i], sz = v.sz[i], dx = v.dx[i], dy = v.dy[i], dz = v.dz[i];
    const double radius2 = sx * sx + sy * sy, length2 = radius2 + sz * sz;
    const double difference2 = dx * dx + dy * dy + dz * dz;
    const double length = std::sqrt(length2);
    // Tangent and bitangent at the half vector, both scaled by |wi + wo| times its radius: no division. The difference
    // vector has the direction of wi's part across h, without wi's part along h: no cancellation.
    const bool pole = !(radius2 > minSquaredPoleRadius * length2);
    const double alongTangent = pole ? dx : sz * (sx * dx + sy * dy) - radius2 * dz;
    const double alongBitangent = pole ? dy : length * (sx * dy - sy * dx);
    const double thetaH = fastAtan2(std::sqrt(radius2), sz);
    const double thetaD = fastAtan2(std::sqrt(difference2), length);
    const double phiD = fastAtan2(alongBitangent, alongTangent);
    const bool valid = length2 >= minSquaredHalfLength;
    block.thetaH[i] = valid ? thetaH : 0.0;
    block.thetaD[i] = valid ? thetaD : 0.0;
    block.phiD[i] = valid && difference2 >= minSquaredDifference ? phiD : 0.0;
    block.valid[i] = valid ? 1 : 0;
  }
}

}  // namespace gonio
