// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/shaders/view_lobes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "core/export/shaders/picture_cells.h"
#include "core/fitting/bounded_least_squares.h"

namespace gonio::exports {

namespace {

using fitting::LinearMatrix;
using fitting::LinearVector;

constexpr double lastKnotDegrees = 85;
constexpr double minAlpha = 0.002;
constexpr std::size_t candidateWidths = 18;

/// G_1 / (2 cos theta): nothing is divided by a cosine.
double foldedMasking(double cosine, double alpha2) {
  return 1 / (cosine + std::sqrt(alpha2 + (1 - alpha2) * cosine * cosine));
}

/// D G / (4 cos theta_i cos theta_o)
double lobeValue(const Direction& wi, const Direction& wo, double alpha, BlenderVersion blender) {
  const Direction half = glm::normalize(wi + wo);
  const double alpha2 = alpha * alpha, sin2 = half.x * half.x + half.y * half.y;
  const double slope = sin2 + alpha2 * half.z * half.z;
  const double i = foldedMasking(wi.z, alpha2), o = foldedMasking(wo.z, alpha2);
  // 1 / G_2 = 1 / G_1(i) + 1 / G_1(o) - 1
  const double masking =
      blender == BlenderVersion::v3 ? i * o : i * o / (2 * (wi.z * i + wo.z * o) - 4 * wi.z * wo.z * i * o);
  return alpha2 / (pi * slope * slope) * masking;
}

class ViewLobesBrdf : public Brdf {
 public:
  explicit ViewLobesBrdf(ViewLobes lobes) : lobes_(std::move(lobes)) {}

  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) values[i] = value(pairs[i].wi, pairs[i].wo);
  }
  using Brdf::evaluate;
  bool isReciprocal() const override { return false; }

 private:
  Rgb value(const Direction& wi, const Direction& wo) const {
    if (!(wi.z > 0 && wo.z > 0)) return Rgb(0);
    const auto at = place(std::acos(std::min(1.0, wo.z)));
    const auto weight = [&](const std::vector<Rgb>& row) {
      return at.fraction > 0 ? glm::mix(row[at.knot], row[at.knot + 1], at.fraction) : row[at.knot];
    };
    Rgb sum = weight(lobes_.weights[0]) / pi;
    for (std::size_t j = 0; j < lobes_.alphas.size(); ++j)
      sum += weight(lobes_.weights[j + 1]) * lobeValue(wi, wo, lobes_.alphas[j], lobes_.blender);
    return sum;
  }

  struct Place {
    std::size_t knot;
    double fraction;  ///< of the way to the next knot
  };
  Place place(double theta) const {
    const std::vector<double>& t = lobes_.thetas;
    if (theta <= t.front()) return {0, 0};
    if (theta >= t.back()) return {t.size() - 1, 0};
    const auto after = std::size_t(std::ranges::upper_bound(t, theta) - t.begin());
    return {after - 1, (theta - t[after - 1]) / (t[after] - t[after - 1])};
  }

  ViewLobes lobes_;
};

/// The linear problem of one knot: the lobes' light against the material's.
struct KnotProblem {
  LinearMatrix normal;
  LinearMatrix rightSides;  ///< a column for each channel
};

/// Columns of residuals: Lambert, then the lobes.
LinearMatrix lobeColumns(const PictureCells& cells, std::span<const double> alphas, BlenderVersion blender) {
  LinearMatrix columns(Eigen::Index(cells.residualCount()), Eigen::Index(alphas.size() + 1));
  std::vector<double> values(cells.pairs().size());
  const auto weigh = [&](Eigen::Index column) {
    cells.computeResiduals(values, {columns.col(column).data(), cells.residualCount()});
  };
  std::ranges::fill(values, 1 / pi);
  weigh(0);
  for (std::size_t j = 0; j < alphas.size(); ++j) {
    std::ranges::transform(cells.pairs(), values.begin(),
                           [&](const DirectionPair& pair) { return lobeValue(pair.wi, pair.wo, alphas[j], blender); });
    weigh(Eigen::Index(j + 1));
  }
  return columns;
}

std::vector<KnotProblem> knotProblems(const Brdf& material, std::span<const double> thetas,
                                      std::span<const double> alphas, BlenderVersion blender) {
  const PictureCells cells(thetas);
  const LinearMatrix columns = lobeColumns(cells, alphas, blender);
  const std::vector<double> residuals = cells.residualsOfMaterial(material);
  const Eigen::Map<const LinearMatrix> target(residuals.data(), columns.rows(), 3);
  const auto rows = Eigen::Index(cells.residualsOfViewer());
  std::vector<KnotProblem> problems;
  for (std::size_t k = 0; k < thetas.size(); ++k) {
    const auto lobes = columns.middleRows(Eigen::Index(k) * rows, rows);
    problems.push_back(
        {lobes.transpose() * lobes, lobes.transpose() * target.middleRows(Eigen::Index(k) * rows, rows)});
  }
  return problems;
}

/// Weights [column][channel] of the columns that are used; 0 for the others.
LinearMatrix solveKnot(const KnotProblem& problem, std::span<const Eigen::Index> used) {
  constexpr double unlimited = 1e9, ridge = 1e-9;
  const auto n = Eigen::Index(used.size());
  LinearMatrix normal(n, n), result = LinearMatrix::Zero(problem.normal.rows(), 3);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) normal(i, j) = problem.normal(used[i], used[j]);
  normal.diagonal() *= 1 + ridge;
  for (int channel = 0; channel < 3; ++channel) {
    LinearVector right(n);
    for (Eigen::Index i = 0; i < n; ++i) right(i) = problem.rightSides(used[i], channel);
    const LinearVector found =
        fitting::solveBounded(normal, right, LinearVector::Zero(n), LinearVector::Constant(n, unlimited));
    for (Eigen::Index i = 0; i < n; ++i) result(used[i], channel) = std::max(0.0, found(i));
  }
  return result;
}

/// The Lambertian column and the `count` lobes that reflect most.
std::vector<Eigen::Index> strongest(std::span<const KnotProblem> problems, std::span<const double> thetas,
                                    std::size_t count) {
  std::vector<Eigen::Index> all(std::size_t(problems[0].normal.rows()));
  std::iota(all.begin(), all.end(), Eigen::Index(0));
  LinearVector energy = LinearVector::Zero(Eigen::Index(all.size()));
  for (std::size_t k = 0; k < problems.size(); ++k)
    energy += std::sin(thetas[k] + 0.1) * std::cos(thetas[k]) * solveKnot(problems[k], all).rowwise().sum();
  std::ranges::sort(all.begin() + 1, all.end(), [&](auto a, auto b) { return energy(a) > energy(b); });
  all.resize(std::min(all.size(), count + 1));
  std::ranges::sort(all);
  return all;
}

}  // namespace

std::shared_ptr<const Brdf> viewLobesBrdf(ViewLobes lobes) {
  return std::make_shared<const ViewLobesBrdf>(std::move(lobes));
}

ViewLobes fitViewLobes(const Brdf& material, const ViewLobesSize& size, const TaskControl& control) {
  std::vector<double> alphas(candidateWidths);
  for (std::size_t j = 0; j < candidateWidths; ++j)
    alphas[j] = std::pow(minAlpha, 1 - double(j) / double(candidateWidths - 1));
  ViewLobes result{.blender = size.blender};
  for (std::size_t k = 0; k < size.knots; ++k)
    result.thetas.push_back(radians(lastKnotDegrees) * double(k) / double(size.knots - 1));
  const std::vector<KnotProblem> problems = knotProblems(material, result.thetas, alphas, size.blender);
  control.throwIfStopped();
  const std::vector<Eigen::Index> used = strongest(problems, result.thetas, size.lobes);
  result.weights.assign(used.size(), std::vector<Rgb>(size.knots));
  for (std::size_t j = 1; j < used.size(); ++j) result.alphas.push_back(alphas[std::size_t(used[j] - 1)]);
  for (std::size_t k = 0; k < size.knots; ++k) {
    const LinearMatrix weights = solveKnot(problems[k], used);
    for (std::size_t j = 0; j < used.size(); ++j)
      result.weights[j][k] = Rgb(weights(used[j], 0), weights(used[j], 1), weights(used[j], 2));
  }
  return result;
}

}  // namespace gonio::exports
