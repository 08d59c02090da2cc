// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/view_lobes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "core/fitting/bounded_quadratic.h"
#include "core/math/parallel.h"

namespace gonio::exports {

namespace {

using fitting::LinearMatrix;
using fitting::LinearVector;

constexpr int polarNodes = 40, azimuthNodes = 32, turns = 8;
constexpr double lastKnotDegrees = 85;
constexpr double albedoWeight = 1;  // 1/sr: of the error of the albedo against those of single directions
constexpr double smallestAlpha = 0.01;
constexpr std::size_t candidateWidths = 14;

/// G_1 / (2 cos theta): nothing is divided by a cosine.
double foldedMasking(double cosine, double alpha2) {
  return 1 / (cosine + std::sqrt(alpha2 + (1 - alpha2) * cosine * cosine));
}

/// D G / (4 cos theta_i cos theta_o)
double lobeValue(const Direction& wi, const Direction& wo, double alpha) {
  const Direction half = glm::normalize(wi + wo);
  const double alpha2 = alpha * alpha, sin2 = half.x * half.x + half.y * half.y;
  const double slope = sin2 + alpha2 * half.z * half.z;
  return alpha2 / (pi * slope * slope) * foldedMasking(wi.z, alpha2) * foldedMasking(wo.z, alpha2);
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
    const auto [knot, fraction] = place(std::acos(std::min(1.0, wo.z)));
    const auto weight = [&](const std::vector<Rgb>& row) {
      return fraction > 0 ? glm::mix(row[knot], row[knot + 1], fraction) : row[knot];
    };
    Rgb sum = weight(lobes_.weights[0]) / pi;
    for (std::size_t j = 0; j < lobes_.alphas.size(); ++j)
      sum += weight(lobes_.weights[j + 1]) * lobeValue(wi, wo, lobes_.alphas[j]);
    return sum;
  }

  std::pair<std::size_t, double> place(double theta) const {
    const std::vector<double>& t = lobes_.thetas;
    if (theta <= t.front()) return {0, 0};
    if (theta >= t.back()) return {t.size() - 1, 0};
    const auto after = std::size_t(std::ranges::upper_bound(t, theta) - t.begin());
    return {after - 1, (theta - t[after - 1]) / (t[after] - t[after - 1])};
  }

  ViewLobes lobes_;
};

/// A direction of the light for one viewer.
struct LightNode {
  Direction wi;
  double solidAngle;  ///< sr
};

/// All of them, dense where the half vector is near the normal.
std::vector<LightNode> lightNodes(const Direction& wo) {
  std::vector<LightNode> nodes;
  for (int i = 0; i < polarNodes; ++i) {
    const double u = (i + 0.5) / polarNodes, theta = u * u * u * pi / 2, step = 3 * u * u * pi / 2 / polarNodes;
    for (int j = 0; j < azimuthNodes; ++j) {
      const double phi = 2 * pi * (j + 0.5) / azimuthNodes;
      const Direction half(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      const double projection = glm::dot(wo, half);
      const Direction wi = 2 * projection * half - wo;
      if (projection <= 0 || wi.z <= 1e-3) continue;
      nodes.push_back({wi, 4 * projection * std::sin(theta) * step * 2 * pi / azimuthNodes});
    }
  }
  return nodes;
}

/// f cos theta_i, of an anisotropic material the mean over the azimuths.
Rgb meanResponse(const Brdf& material, const Direction& wi, const Direction& wo) {
  const int count = material.isIsotropic() ? 1 : turns;
  Rgb sum(0);
  for (int i = 0; i < count; ++i) {
    const double phi = 2 * pi * i / count, c = std::cos(phi), s = std::sin(phi);
    const auto turned = [&](const Direction& w) { return Direction(c * w.x - s * w.y, s * w.x + c * w.y, w.z); };
    sum += material.evaluate(turned(wi), turned(wo));
  }
  return glm::max(sum, Rgb(0)) * (wi.z / count);
}

/// The linear problem of one knot: the lobes' responses against the material's.
struct KnotProblem {
  LinearMatrix normal;
  LinearMatrix rightSides;  ///< a column for each channel
};

KnotProblem knotProblem(const Brdf& material, double theta, std::span<const double> alphas) {
  const Direction wo(std::sin(theta), 0, std::cos(theta));
  const auto lobes = Eigen::Index(alphas.size() + 1);
  // Columns: the lobes, then R, G and B of the material.
  LinearMatrix normal = LinearMatrix::Zero(lobes + 3, lobes + 3);
  LinearVector response(lobes + 3), albedo = LinearVector::Zero(lobes + 3);
  for (const auto& [wi, solidAngle] : lightNodes(wo)) {
    response(0) = wi.z / pi;
    for (Eigen::Index c = 1; c < lobes; ++c) response(c) = wi.z * lobeValue(wi, wo, alphas[std::size_t(c - 1)]);
    const Rgb measured = meanResponse(material, wi, wo);
    for (int channel = 0; channel < 3; ++channel) response(lobes + channel) = measured[channel];
    normal += solidAngle * response * response.transpose();
    albedo += solidAngle * response;
  }
  normal += albedoWeight * albedo * albedo.transpose();
  return {normal.topLeftCorner(lobes, lobes), normal.topRightCorner(lobes, 3)};
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
    alphas[j] = std::pow(smallestAlpha, 1 - double(j) / double(candidateWidths - 1));
  ViewLobes result;
  for (std::size_t k = 0; k < size.knots; ++k)
    result.thetas.push_back(radians(lastKnotDegrees) * double(k) / double(size.knots - 1));
  std::vector<KnotProblem> problems(size.knots);
  parallelForBlocks(
      size.knots, 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) problems[k] = knotProblem(material, result.thetas[k], alphas);
      },
      control);
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
