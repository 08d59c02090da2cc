// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/rgb_spectra.h"

#include <algorithm>

#include "core/fitting/bounded_quadratic.h"
#include "core/math/spectrum.h"

namespace gonio::exports {

namespace {

using fitting::LinearMatrix;
using fitting::LinearVector;

constexpr int knots = 18, channels = 3, unknowns = knots * channels;
constexpr float firstKnot = 380, knotStep = 20;

int unknown(int channel, int knot) { return channel * knots + knot; }

/// A quadratic programme whose equations are terms of a great weight: their residues fall to about its inverse.
struct Programme {
  LinearMatrix normal = LinearMatrix::Zero(unknowns, unknowns);
  LinearVector rightSide = LinearVector::Zero(unknowns);

  /// weight (row . x - wanted)^2 / 2
  void add(const LinearVector& row, double wanted, double weight) {
    normal += weight * row * row.transpose();
    rightSide += weight * wanted * row;
  }
};

Programme smoothestBasis(const std::vector<Rgb>& observer) {
  constexpr double equation = 1e8;
  Programme programme;
  for (int c = 0; c < channels; ++c) {
    for (int k = 1; k + 1 < knots; ++k) {
      LinearVector bend = LinearVector::Zero(unknowns);
      bend[unknown(c, k - 1)] = bend[unknown(c, k + 1)] = 1;
      bend[unknown(c, k)] = -2;
      programme.add(bend, 0, 1);
    }
    for (int seen = 0; seen < channels; ++seen) {
      LinearVector row = LinearVector::Zero(unknowns);
      for (int k = 0; k < knots; ++k) row[unknown(c, k)] = observer[std::size_t(k)][seen];
      programme.add(row, seen == c ? 1 : 0, equation);
    }
  }
  for (int k = 0; k < knots; ++k) {
    LinearVector sum = LinearVector::Zero(unknowns);
    for (int c = 0; c < channels; ++c) sum[unknown(c, k)] = 1;
    programme.add(sum, 1, equation);
  }
  return programme;
}

SpectralBasis computeBasis() {
  SpectralBasis basis;
  for (int k = 0; k < knots; ++k) basis.nanometres.push_back(firstKnot + knotStep * float(k));
  const auto observer = spectrumWeights(std::vector<double>(basis.nanometres.begin(), basis.nanometres.end()));
  const Programme programme = smoothestBasis(observer);
  const LinearVector solution = fitting::solveBounded(programme.normal, programme.rightSide,
                                                      LinearVector::Zero(unknowns), LinearVector::Ones(unknowns));
  for (int k = 0; k < knots; ++k)
    basis.values.push_back({solution[unknown(0, k)], solution[unknown(1, k)], solution[unknown(2, k)]});
  return basis;
}

}  // namespace

const SpectralBasis& spectralBasis() {
  static const SpectralBasis basis = computeBasis();
  return basis;
}

Rgb spectralBasisAt(double nanometres) {
  const SpectralBasis& basis = spectralBasis();
  const auto above = std::ranges::lower_bound(basis.nanometres, float(nanometres));
  if (above == basis.nanometres.begin()) return basis.values.front();
  if (above == basis.nanometres.end()) return basis.values.back();
  const auto high = std::size_t(above - basis.nanometres.begin());
  const double low = basis.nanometres[high - 1], fraction = (nanometres - low) / (double(*above) - low);
  return glm::mix(basis.values[high - 1], basis.values[high], fraction);
}

}  // namespace gonio::exports
