// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rgl/rgb_spectra.h"

#include <algorithm>
#include <array>
#include <glm/mat3x3.hpp>

#include "core/fitting/bounded_least_squares.h"
#include "core/math/colour.h"

namespace gonio::rgl {

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

using Spectrum = std::array<double, knots>;

/// Three spectra, their colours as columns, and the matrix from a colour to their factors.
struct Triangle {
  std::array<Spectrum, 3> corners;
  glm::dmat3 colours, factors;
};

int knotAt(double nanometres) { return int((nanometres - firstKnot) / knotStep); }

/// A fan of triangles in the diagram of chromaticities: the one of sRGB, and those between its corners and the spectra
/// of one knot, or of two for purple.
class Fan {
 public:
  Fan() {
    const std::vector<float>& nanometres = spectralBasis().nanometres;
    observer_ = spectrumWeights(std::vector<double>(nanometres.begin(), nanometres.end()));
    std::array<Spectrum, 3> primaries{};
    for (int k = 0; k < knots; ++k)
      for (int c = 0; c < channels; ++c)
        primaries[std::size_t(c)][std::size_t(k)] = spectralBasis().values[std::size_t(k)][c];
    const auto& [red, green, blue] = primaries;
    Spectrum purple{};
    for (std::size_t k = 0; k < knots; ++k) purple[k] = single(reddest)[k] + single(bluest)[k];
    add(red, green, blue);
    for (int nm = reddest; nm > bluest; nm -= int(knotStep)) {
      const Spectrum& inner = nm > 580 ? red : nm > 500 ? green : blue;
      add(inner, single(nm), single(nm - int(knotStep)));
    }
    add(red, single(580), green);
    add(green, single(500), blue);
    add(blue, single(bluest), purple);
    add(blue, purple, red);
    add(red, purple, single(reddest));
  }

  static const Fan& instance() {
    static const Fan fan;
    return fan;
  }

  /// The triangle that a colour lies in, or comes nearest to, with factors of at least 0.
  std::pair<const Triangle*, Rgb> find(const Rgb& colour) const {
    std::pair<const Triangle*, Rgb> best{nullptr, Rgb(0)};
    for (const Triangle& triangle : triangles_) {
      const Rgb factors = triangle.factors * colour;
      if (!best.first || least(factors) > least(best.second)) best = {&triangle, factors};
      if (least(factors) >= 0) break;
    }
    best.second = glm::max(best.second, Rgb(0));
    return best;
  }

 private:
  /// nm: the ends of the locus, with the approximated observer of core/math/colour.h.
  static constexpr int reddest = 640, bluest = 440;

  void add(const Spectrum& a, const Spectrum& b, const Spectrum& c) {
    const glm::dmat3 colours(colourOf(a), colourOf(b), colourOf(c));
    triangles_.push_back({{a, b, c}, colours, glm::inverse(colours)});
  }

  static double least(const Rgb& factors) { return std::min({factors.x, factors.y, factors.z}); }

  Rgb colourOf(const Spectrum& spectrum) const {
    Rgb sum(0);
    for (std::size_t k = 0; k < knots; ++k) sum += spectrum[k] * observer_[k];
    return sum;
  }
  /// The spectrum of one knot, scaled so that the largest channel is 1.
  Spectrum single(double nanometres) const {
    Spectrum spectrum{};
    const auto knot = std::size_t(knotAt(nanometres));
    spectrum[knot] = 1 / maxChannel(observer_[knot]);
    return spectrum;
  }

  std::vector<Rgb> observer_;
  std::vector<Triangle> triangles_;
};

}  // namespace

void colourSpectrum(const Rgb& colour, std::span<float> values) {
  const auto [triangle, factors] = Fan::instance().find(colour);
  for (std::size_t k = 0; k < knots; ++k)
    values[k] = float(factors.x * triangle->corners[0][k] + factors.y * triangle->corners[1][k] +
                      factors.z * triangle->corners[2][k]);
}

Rgb spectralColour(const Rgb& colour) {
  const auto [triangle, factors] = Fan::instance().find(colour);
  return triangle->colours * factors;
}

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

}  // namespace gonio::rgl
