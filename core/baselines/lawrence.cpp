// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/lawrence.h"

#include <algorithm>
#include <cmath>

#include "core/baselines/half_vector_sampler.h"
#include "core/coordinates/half_out.h"
#include "core/factorization/deviation_grid.h"
#include "core/factorization/half_difference_samples.h"
#include "core/factorization/nonnegative_matrix.h"
#include "core/math/monotone_cubic.h"

namespace gonio::baselines {

namespace {

using Eigen::Index;

const factorization::NonnegativeOptions updates{.maxIterations = 1000, .tolerance = 1e-7};

/// Roots of the solid angles of rows and of the projected ones of columns: a cell's error counts by its fraction of
/// the light.
Eigen::VectorXd rowScales(const HalfOutAxes& axes) {
  Eigen::VectorXd scales(Index(axes.thetaH.size() * axes.phiH.size()));
  for (Index row = 0; row < scales.size(); ++row)
    scales[row] = std::sqrt(factorization::solidAngle(axes.thetaH, std::size_t(row) / axes.phiH.size()));
  return scales;
}
Eigen::VectorXd columnScales(const HalfOutAxes& axes) {
  Eigen::VectorXd scales(Index(3 * axes.thetaO.size()));
  for (Index column = 0; column < scales.size(); ++column) {
    const std::size_t o = std::size_t(column) / 3;
    scales[column] = std::sqrt(factorization::solidAngle(axes.thetaO, o) * std::cos(axes.thetaO[o]));
  }
  return scales;
}

/// Rows (theta_h, phi_h), columns (theta_o, channel).
Eigen::MatrixXd cosineWeighted(const HalfOutSamples& s) {
  const HalfOutAxes& axes = s.axes;
  Eigen::MatrixXd matrix(Index(axes.thetaH.size() * axes.phiH.size()), Index(3 * axes.thetaO.size()));
  for (Index row = 0; row < matrix.rows(); ++row)
    for (Index o = 0; o < Index(axes.thetaO.size()); ++o)
      for (int channel = 0; channel < 3; ++channel) {
        const std::size_t at = std::size_t(row) * axes.thetaO.size() + std::size_t(o);
        matrix(row, 3 * o + channel) = s.valid[at] ? s.values[at][channel] * s.cosI[at] : 0;
      }
  return matrix;
}

double between(const Eigen::MatrixXd::ConstColXpr& curve, const NodeInterval& at) {
  return (1 - at.fraction) * curve[Index(at.index)] + at.fraction * curve[Index(at.index + 1)];
}

/// Times the cosine of the light.
Rgb cosineWeightedAt(const LawrenceFactors& f, const HalfOut& at) {
  const NodeInterval o = findInterval(f.axes.thetaO, at.thetaO), h = findInterval(f.axes.thetaH, at.thetaH),
                     p = findInterval(f.axes.phiH, std::abs(at.phiH));
  Rgb sum(0);
  for (int j = 0, product = 0; j < f.ranks.terms; ++j) {
    double strength = 0;
    for (int k = 0; k < f.ranks.products; ++k, ++product)
      strength += between(f.polar.col(product), h) * between(f.azimuth.col(product), p);
    for (int channel = 0; channel < 3; ++channel)
      sum[channel] += strength * ((1 - o.fraction) * f.viewer(j, 3 * Index(o.index) + channel) +
                                  o.fraction * f.viewer(j, 3 * Index(o.index + 1) + channel));
  }
  return sum;
}

/// Each product with the luminance of its F.
HalfVectorSampler samplerOf(const LawrenceFactors& f) {
  const auto curve = [](const auto& column) { return std::vector<double>(column.begin(), column.end()); };
  std::vector<HalfVectorSampler::Product> products;
  for (int j = 0, product = 0; j < f.ranks.terms; ++j) {
    std::vector<double> viewer;
    for (Index o = 0; o < Index(f.axes.thetaO.size()); ++o)
      viewer.push_back(luminance(Rgb(f.viewer(j, 3 * o), f.viewer(j, 3 * o + 1), f.viewer(j, 3 * o + 2))));
    for (int k = 0; k < f.ranks.products; ++k, ++product)
      products.push_back({curve(f.polar.col(product)), curve(f.azimuth.col(product)), viewer});
  }
  return {f.axes, products};
}

class LawrenceBrdf final : public Brdf {
 public:
  explicit LawrenceBrdf(LawrenceFactors factors) : factors_(std::move(factors)), sampler_(samplerOf(factors_)) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [wi, wo] = pairs[i];
      values[i] = Rgb(0);
      if (isBelowHorizon(wi) || isBelowHorizon(wo)) continue;
      if (const HalfOut at = toHalfOut(wi, wo); at.valid)
        values[i] = cosineWeightedAt(factors_, at) / std::max(wi.z, std::cos(factorization::maxPolarAngle));
    }
  }
  bool isReciprocal() const override { return false; }
  bool hasImportanceSampling() const override { return true; }
  double samplingCost() const override { return 2; }
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override { return sampler_.sample(wo, u); }
  double pdf(const Direction& wi, const Direction& wo) const override { return sampler_.pdf(wi, wo); }

 private:
  LawrenceFactors factors_;
  HalfVectorSampler sampler_;
};

}  // namespace

HalfOutAxes lawrenceAxes() { return makeHalfOutAxes(90, 24, 30); }

LawrenceRanks lawrenceRanks(const HalfOutAxes& axes, std::size_t byteBudget) {
  const std::size_t room = byteBudget / sizeof(float);
  for (std::size_t products = 4; products > 1; --products) {
    const std::size_t term = 3 * axes.thetaO.size() + products * (axes.thetaH.size() + axes.phiH.size());
    if (room / term > products) return {.terms = int(room / term), .products = int(products)};
  }
  const std::size_t term = 3 * axes.thetaO.size() + axes.thetaH.size() + axes.phiH.size();
  return {.terms = int(std::max<std::size_t>(1, room / term)), .products = 1};
}

LawrenceFactors factorizeLawrence(const HalfOutSamples& samples, const LawrenceRanks& ranks,
                                  const TaskControl& control) {
  const HalfOutAxes& axes = samples.axes;
  const auto heights = Index(axes.thetaH.size()), azimuths = Index(axes.phiH.size());
  const Eigen::VectorXd rows = rowScales(axes), columns = columnScales(axes);
  factorization::NonnegativeFactors outer = factorization::factorizeNonnegative(
      rows.asDiagonal() * cosineWeighted(samples) * columns.asDiagonal(), ranks.terms, updates, {.stop = control.stop});
  outer.right = outer.right * columns.cwiseInverse().asDiagonal();
  LawrenceFactors result{.axes = axes,
                         .ranks = ranks,
                         .viewer = std::move(outer.right),
                         .polar = Eigen::MatrixXd(heights, ranks.terms * ranks.products),
                         .azimuth = Eigen::MatrixXd(azimuths, ranks.terms * ranks.products)};
  // Both levels work on the scaled cells; the scale of a row does not depend on its azimuth.
  const Eigen::VectorXd heightScales = rows(Eigen::seqN(0, heights, azimuths));
  for (int j = 0; j < ranks.terms; ++j) {
    // Rows of the outer factor run over phi_h fastest: seen as a matrix each column is one theta_h.
    const Eigen::MatrixXd column = outer.left.col(j).reshaped(azimuths, heights).transpose();
    const factorization::NonnegativeFactors inner =
        factorization::factorizeNonnegative(column, ranks.products, updates, {.stop = control.stop});
    result.polar.middleCols(j * ranks.products, ranks.products) = heightScales.cwiseInverse().asDiagonal() * inner.left;
    result.azimuth.middleCols(j * ranks.products, ranks.products) = inner.right.transpose();
    control.report(double(j + 1) / ranks.terms);
  }
  return result;
}

std::shared_ptr<const Brdf> makeLawrenceBrdf(LawrenceFactors factors) {
  return std::make_shared<const LawrenceBrdf>(std::move(factors));
}

}  // namespace gonio::baselines
