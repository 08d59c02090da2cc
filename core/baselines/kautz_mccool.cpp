// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/kautz_mccool.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/brdf.h"
#include "core/factorization/half_difference_samples.h"
#include "core/factorization/nonnegative_matrix.h"
#include "core/math/decompositions.h"
#include "core/math/monotone_cubic.h"

namespace gonio::baselines {

namespace {

using Eigen::Index;

/// Factors of the channels by which they become comparable: 1 unless a channel is less than a thousandth as bright as
/// the brightest one, whose errors would otherwise hide it.
Rgb channelScales(const factorization::HalfDifferenceSamples& s) {
  constexpr double darkest = 1e-3;
  Rgb largest(0), scales(1);
  for (std::size_t i = 0; i < s.values.size(); ++i)
    if (s.valid[i]) largest = glm::max(largest, s.values[i]);
  for (int channel = 0; channel < 3; ++channel)
    if (largest[channel] > 0 && largest[channel] < darkest * maxChannel(largest))
      scales[channel] = maxChannel(largest) / largest[channel];
  return scales;
}

/// Roots of the weights of rows (theta_h, channel) and columns (theta_d, phi_d): their product is the projected measure
/// of the cell, with cos theta_i cos theta_o taken at phi_d = pi / 2, where it is a product.
Eigen::VectorXd rowScales(const factorization::HalfDifferenceSamples& samples) {
  const factorization::HalfDifferenceAxes& axes = samples.axes;
  const Rgb channels = channelScales(samples);
  Eigen::VectorXd scales(Index(3 * axes.thetaH.size()));
  for (Index row = 0; row < scales.size(); ++row) {
    const std::size_t h = std::size_t(row) / 3;
    scales[row] =
        std::sqrt(factorization::solidAngle(axes.thetaH, h)) * std::cos(axes.thetaH[h]) * channels[int(row % 3)];
  }
  return scales;
}
Eigen::VectorXd columnScales(const factorization::HalfDifferenceAxes& axes) {
  Eigen::VectorXd scales(Index(axes.thetaD.size() * axes.phiD.size()));
  for (Index column = 0; column < scales.size(); ++column) {
    const std::size_t d = std::size_t(column) / axes.phiD.size(), p = std::size_t(column) % axes.phiD.size();
    scales[column] = std::sqrt(factorization::solidAngle(axes.thetaD, d) * std::cos(axes.thetaD[d]) *
                               factorization::nodeSpacing(axes.phiD, p)) *
                     std::cos(axes.thetaD[d]);
  }
  return scales;
}

/// Holes take the value of the theta_h before: the mirror direction itself always has one but at the horizon.
Eigen::MatrixXd filled(const factorization::HalfDifferenceSamples& s) {
  const factorization::HalfDifferenceAxes& axes = s.axes;
  Eigen::MatrixXd matrix(Index(3 * axes.thetaH.size()), Index(axes.thetaD.size() * axes.phiD.size()));
  for (Index column = 0; column < matrix.cols(); ++column) {
    Rgb known(0);
    for (std::size_t h = 0; h < axes.thetaH.size(); ++h) {
      const std::size_t i = h * std::size_t(matrix.cols()) + std::size_t(column);
      if (s.valid[i]) known = s.values[i];
      for (int channel = 0; channel < 3; ++channel) matrix(Index(3 * h) + channel, column) = known[channel];
    }
  }
  return matrix;
}

Rgb sumAt(const KautzMcCoolFactors& f, const HalfDifference& at) {
  // Reciprocity and the plane of incidence fold the azimuth to [0, pi / 2].
  const double phiD = std::abs(at.phiD);
  const NodeInterval h = findInterval(f.axes.thetaH, at.thetaH), d = findInterval(f.axes.thetaD, at.thetaD),
                     p = findInterval(f.axes.phiD, std::min(phiD, pi - phiD));
  const Index column = Index(d.index * f.axes.phiD.size() + p.index), nextD = Index(f.axes.phiD.size());
  const Index row = Index(3 * h.index);
  Rgb sum(0);
  for (Index k = 0; k < f.half.cols(); ++k) {
    const double v =
        (1 - d.fraction) * ((1 - p.fraction) * f.difference(column, k) + p.fraction * f.difference(column + 1, k)) +
        d.fraction *
            ((1 - p.fraction) * f.difference(column + nextD, k) + p.fraction * f.difference(column + nextD + 1, k));
    for (int channel = 0; channel < 3; ++channel)
      sum[channel] += v * ((1 - h.fraction) * f.half(row + channel, k) + h.fraction * f.half(row + 3 + channel, k));
  }
  return sum;
}

std::size_t termBytes(const factorization::HalfDifferenceAxes& axes) {
  return (3 * axes.thetaH.size() + axes.thetaD.size() * axes.phiD.size()) * sizeof(float);
}

}  // namespace

KautzMcCoolFactors KautzMcCoolFactors::truncated(int terms) const {
  const Index count = std::clamp(Index(terms), Index(1), half.cols());
  return {.axes = axes,
          .half = half.leftCols(count),
          .difference = difference.leftCols(count),
          .residuals = {residuals.begin(), residuals.begin() + count + 1}};
}

factorization::HalfDifferenceAxes kautzMcCoolAxes() { return factorization::makeHalfDifferenceAxes(90, 30, 7); }

int kautzMcCoolTerms(const factorization::HalfDifferenceAxes& axes, std::size_t byteBudget) {
  const std::size_t exact = std::min(3 * axes.thetaH.size(), axes.thetaD.size() * axes.phiD.size());
  return int(std::clamp(byteBudget / termBytes(axes), std::size_t(1), exact));
}

KautzMcCoolFactors factorizeKautzMcCool(const factorization::HalfDifferenceSamples& samples, int terms,
                                        const TaskControl& control) {
  control.throwIfStopped();
  const Eigen::VectorXd rows = rowScales(samples), columns = columnScales(samples.axes);
  const ThinSvd svd = thinSvd(rows.asDiagonal() * filled(samples) * columns.asDiagonal());
  const Eigen::VectorXd& strengths = svd.singularValues;
  const Index count = std::clamp(Index(terms), Index(1), strengths.size());
  KautzMcCoolFactors result{.axes = samples.axes};
  result.half = rows.cwiseInverse().asDiagonal() * svd.u.leftCols(count) * strengths.head(count).asDiagonal();
  result.difference = columns.cwiseInverse().asDiagonal() * svd.v.leftCols(count);
  const double total = strengths.norm();
  for (Index k = 0; k <= count; ++k)
    result.residuals.push_back(total > 0 ? strengths.tail(strengths.size() - k).norm() / total : 0);
  return result;
}

KautzMcCoolFactors factorizeNonnegativeHalfDifference(const factorization::HalfDifferenceSamples& samples, int terms,
                                                      const TaskControl& control) {
  const Eigen::VectorXd rows = rowScales(samples), columns = columnScales(samples.axes);
  const Eigen::MatrixXd matrix = rows.asDiagonal() * filled(samples) * columns.asDiagonal();
  const factorization::NonnegativeFactors found =
      factorization::factorizeNonnegative(matrix, terms, {.maxIterations = 1000, .tolerance = 1e-7}, control);
  KautzMcCoolFactors result{.axes = samples.axes};
  result.half = rows.cwiseInverse().asDiagonal() * found.left;
  result.difference = columns.cwiseInverse().asDiagonal() * found.right.transpose();
  const double total = matrix.norm();
  result.residuals = {total > 0 ? 1.0 : 0.0, total > 0 ? found.residuals.back() / total : 0.0};
  return result;
}

std::shared_ptr<const Brdf> makeKautzMcCoolBrdf(KautzMcCoolFactors factors) {
  return makePairwiseBrdf([f = std::move(factors)](const Direction& wi, const Direction& wo) {
    const HalfDifference at = toHalfDifference(wi, wo);
    return at.valid ? glm::max(Rgb(0), sumAt(f, at)) : Rgb(0);
  });
}

}  // namespace gonio::baselines
