// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/half_difference_tensor.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "core/brdf/brdf.h"
#include "core/factorization/canonical_polyadic.h"
#include "core/math/monotone_cubic.h"

namespace gonio::baselines {

namespace {

std::array<int, 3> modeSizes(const factorization::HalfDifferenceAxes& axes) {
  return {int(axes.thetaH.size()), int(axes.thetaD.size()), int(axes.phiD.size())};
}

/// Bytes of the four curves of a term.
std::size_t cpTermBytes(const factorization::HalfDifferenceAxes& axes) {
  return (axes.thetaH.size() + axes.thetaD.size() + axes.phiD.size() + 3) * sizeof(float);
}

constexpr std::size_t boundBytes = sizeof(float);  // of `highest`

/// Bytes of the core tensor, and of the matrices of the angles and of the channels.
std::size_t hosvdBytes(const factorization::HalfDifferenceAxes& axes, const std::array<int, 3>& ranks) {
  const std::array<int, 3> sizes = modeSizes(axes);
  std::size_t coreSize = 3, matrices = 3 * 3;
  for (std::size_t mode = 0; mode < 3; ++mode) {
    coreSize *= std::size_t(ranks[mode]);
    matrices += std::size_t(sizes[mode]) * std::size_t(ranks[mode]);
  }
  return (coreSize + matrices) * sizeof(float) + boundBytes;
}

/// Bytes of a coefficient in single precision and its position, of which there are less than 65,536.
constexpr std::size_t cosineBytes = sizeof(float) + sizeof(std::uint16_t);

/// Orthonormal; a row per frequency.
Eigen::MatrixXd cosineTransform(int size) {
  Eigen::MatrixXd matrix(size, size);
  for (int frequency = 0; frequency < size; ++frequency)
    for (int node = 0; node < size; ++node)
      matrix(frequency, node) =
          std::sqrt((frequency == 0 ? 1.0 : 2.0) / size) * std::cos(pi * frequency * (node + 0.5) / size);
  return matrix;
}

/// The decomposition of `tensor` that these values and bytes are.
HalfDifferenceTensor decomposed(const HalfDifferenceTensor& tensor, factorization::Tensor values, std::size_t bytes) {
  HalfDifferenceTensor result{
      .axes = tensor.axes, .values = std::move(values), .highest = tensor.highest, .residual = 0, .bytes = bytes};
  const double norm = tensor.values.norm();
  double squared = 0;
  for (std::size_t i = 0; i < tensor.values.count(); ++i) squared += std::pow(result.values[i] - tensor.values[i], 2);
  if (norm > 0) result.residual = std::sqrt(squared) / norm;
  return result;
}

Rgb valueAt(const HalfDifferenceTensor& tensor, const HalfDifference& at) {
  const factorization::HalfDifferenceAxes& axes = tensor.axes;
  // Reciprocity and the plane of incidence fold the azimuth to [0, pi / 2].
  const double phiD = std::abs(at.phiD);
  const NodeInterval h = findInterval(axes.thetaH, at.thetaH), d = findInterval(axes.thetaD, at.thetaD),
                     p = findInterval(axes.phiD, std::min(phiD, pi - phiD));
  const std::size_t stepD = axes.thetaH.size(), stepP = stepD * axes.thetaD.size(), stepC = stepP * axes.phiD.size();
  const std::size_t first = h.index + stepD * d.index + stepP * p.index;
  Rgb y(0);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const std::size_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
    const double weight =
        (i ? h.fraction : 1 - h.fraction) * (j ? d.fraction : 1 - d.fraction) * (k ? p.fraction : 1 - p.fraction);
    for (std::size_t c = 0; c < 3; ++c)
      y[int(c)] += weight * tensor.values[first + i + j * stepD + k * stepP + c * stepC];
  }
  Rgb rho;
  for (int c = 0; c < 3; ++c) rho[c] = std::expm1(std::clamp(y[c], 0.0, tensor.highest));
  return rho;
}

}  // namespace

HalfDifferenceTensor sampleHalfDifferenceTensor(const factorization::HalfDifferenceSamples& samples) {
  const auto [heights, differences, azimuths] = modeSizes(samples.axes);
  HalfDifferenceTensor result{.axes = samples.axes,
                              .values = factorization::Tensor({heights, differences, azimuths, 3})};
  const std::size_t stepC = result.values.count() / 3;
  std::size_t column = 0;
  for (std::size_t p = 0; p < std::size_t(azimuths); ++p)
    for (std::size_t d = 0; d < std::size_t(differences); ++d, column += std::size_t(heights)) {
      Rgb known(0);
      for (std::size_t h = 0; h < std::size_t(heights); ++h) {
        const std::size_t i = samples.axes.index(h, d, p);
        if (samples.valid[i]) known = samples.values[i];
        for (std::size_t c = 0; c < 3; ++c) {
          const double y = std::log1p(std::max(known[int(c)], 0.0));
          result.values[column + h + c * stepC] = y;
          result.highest = std::max(result.highest, y);
        }
      }
    }
  return result;
}

int cpTerms(const factorization::HalfDifferenceAxes& axes, std::size_t byteBudget) {
  const std::size_t room = byteBudget > boundBytes ? byteBudget - boundBytes : 0;
  return int(std::clamp(room / cpTermBytes(axes), std::size_t(1), std::size_t(maxCpTerms)));
}

HalfDifferenceTensor decomposeCp(const HalfDifferenceTensor& tensor, int terms, const TaskControl& control) {
  const factorization::CanonicalPolyadic found =
      factorization::decomposeCanonicalPolyadic(tensor.values, terms, {.maxIterations = 100}, control);
  return decomposed(tensor, factorization::compose(found), std::size_t(terms) * cpTermBytes(tensor.axes) + boundBytes);
}

std::array<int, 3> hosvdRanks(const factorization::HalfDifferenceAxes& axes, std::size_t byteBudget) {
  const std::array<int, 3> sizes = modeSizes(axes);
  std::array<int, 3> ranks{1, 1, 1};
  for (int step = 1; step <= sizes[0]; ++step) {
    std::array<int, 3> larger;
    for (std::size_t mode = 0; mode < 3; ++mode)
      larger[mode] = std::max(1, int(std::lround(double(sizes[mode]) * step / sizes[0])));
    if (hosvdBytes(axes, larger) > byteBudget) break;
    ranks = larger;
  }
  return ranks;
}

HalfDifferenceTensor decomposeHosvd(const HalfDifferenceTensor& tensor, const std::array<int, 3>& ranks) {
  const factorization::HigherOrderSvd found =
      factorization::decomposeHigherOrderSvd(tensor.values, {ranks[0], ranks[1], ranks[2], 3});
  return decomposed(tensor, factorization::compose(found), hosvdBytes(tensor.axes, ranks));
}

std::size_t cosineCoefficients(const factorization::HalfDifferenceAxes& axes, std::size_t byteBudget) {
  const std::size_t all = 3 * axes.thetaH.size() * axes.thetaD.size() * axes.phiD.size();
  const std::size_t room = byteBudget > boundBytes ? byteBudget - boundBytes : 0;
  return std::clamp(room / cosineBytes, std::size_t(1), all);
}

HalfDifferenceTensor truncateCosineSeries(const HalfDifferenceTensor& tensor, std::size_t coefficients) {
  factorization::Tensor series = tensor.values;
  for (int mode = 0; mode < series.modes(); ++mode)
    series = factorization::modeProduct(series, cosineTransform(series.size(mode)), mode);
  coefficients = std::min(coefficients, series.count());
  std::vector<std::size_t> order(series.count());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto isLarger = [&](std::size_t a, std::size_t b) {
    const double ofA = std::abs(series[a]), ofB = std::abs(series[b]);
    return ofA != ofB ? ofA > ofB : a < b;
  };
  std::nth_element(order.begin(), order.begin() + std::ptrdiff_t(coefficients - 1), order.end(), isLarger);
  for (std::size_t i = coefficients; i < order.size(); ++i) series[order[i]] = 0;
  for (int mode = 0; mode < series.modes(); ++mode)
    series = factorization::transposedModeProduct(series, cosineTransform(series.size(mode)), mode);
  return decomposed(tensor, std::move(series), coefficients * cosineBytes + boundBytes);
}

std::shared_ptr<const Brdf> makeHalfDifferenceTensorBrdf(HalfDifferenceTensor tensor) {
  return makePairwiseBrdf([t = std::move(tensor)](const Direction& wi, const Direction& wo) {
    const HalfDifference at = toHalfDifference(wi, wo);
    return at.valid ? valueAt(t, at) : Rgb(0);
  });
}

}  // namespace gonio::baselines
