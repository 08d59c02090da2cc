// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/plots/slice.h"

#include <algorithm>
#include <cmath>

#include "core/coordinates/half_difference.h"

namespace gonio::plots {

double thetaHFraction(ThetaHSpacing spacing, double thetaH) {
  const double fraction = thetaH / halfPi;
  return spacing == ThetaHSpacing::linear ? fraction : std::sqrt(std::max(0.0, fraction));
}

double thetaHAt(ThetaHSpacing spacing, double fraction) {
  return halfPi * (spacing == ThetaHSpacing::linear ? fraction : fraction * fraction);
}

double Slice::thetaH(int column) const { return thetaHAt(spacing, (column + 0.5) / width); }
double Slice::thetaD(int row) const { return halfPi * (row + 0.5) / height; }

Slice halfDifferenceSlice(const Brdf& brdf, double phiD, ThetaHSpacing spacing, CosineFactor cosine,
                          const TabulatedBrdf* coverage, int size) {
  Slice slice{size, size, spacing, phiD, {}};
  std::vector<DirectionPair> pairs;
  pairs.reserve(std::size_t(size) * std::size_t(size));
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      pairs.push_back(fromHalfDifference(slice.thetaH(column), slice.thetaD(row), phiD));
  slice.cells = evaluatePlotted(brdf, pairs, cosine, coverage);
  return slice;
}

}  // namespace gonio::plots
