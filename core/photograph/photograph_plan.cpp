// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/photograph_plan.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/parallel.h"
#include "core/photograph/pixel_model.h"
#include "core/support/error.h"

namespace gonio::photograph {

using Eigen::Index, Eigen::MatrixXd, Eigen::MatrixX3d, Eigen::VectorXd;

namespace {

/// Mean variance of the mapped values, as a quadratic form of w (x = mean + G w): G^T diag(D^T D) G / cells / channels.
MatrixXd variancePerCell(const PhotographPrior& prior, const MatrixXd& factor) {
  const Index components = prior.d.cols();
  const MatrixXd gram = (prior.d.transpose() * prior.d).cast<double>() / (3 * double(prior.d.rows()));
  MatrixXd result = MatrixXd::Zero(factor.cols(), factor.cols());
  for (Index channel = 0; channel < 3; ++channel) {
    const auto part = factor.middleRows(channel * components, components);
    result += part.transpose() * (gram * part);
  }
  return result;
}

/// The images of a plan as linear observations of w with noise of variance 1.
class Observations {
 public:
  Observations(const PhotographPrior& prior, const PhotographSet& images, const LocalPrior& local,
               const std::vector<std::size_t>& materials, const PlanOptions& options, const TaskControl& control)
      : materials_(materials.size()), rows_(images.photographs.size() * materials.size()) {
    const std::vector<Region> regions = plannedRegions(images, options.regionsPerImage * images.photographs.size());
    const PixelRows pixels = assembleRows(prior.mapping, images, regions, 0, control.between(0, 0.3));
    for (std::size_t m = 0; m < materials.size(); ++m) {
      control.report(0.3 + 0.4 * double(m) / double(materials.size()));
      const PixelLinearisation at =
          linearised(prior, pixels, prior.trainingCoefficients(materials[m]), {control.stop, {}});
      std::size_t end = 0;
      for (std::size_t i = 0; i < images.photographs.size(); ++i) {
        const std::size_t begin = end;
        while (end < regions.size() && regions[end].photograph == i) ++end;
        const double share = sharedInformation(std::span(images.photographs).subspan(i, 1), end - begin);
        rows_[i * materials_ + m] = observed(at, begin, end, share, local, images.exposureKnown, options.modelNoise);
      }
    }
  }

  /// Adds the information of an image about a material to the inverse of the covariance of w.
  void add(std::size_t image, std::size_t material, MatrixXd& normal) const {
    const MatrixXd rows = rows_[image * materials_ + material].cast<double>();
    normal.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
  }

 private:
  static Eigen::MatrixXf observed(const PixelLinearisation& at, std::size_t begin, std::size_t end, double share,
                                  const LocalPrior& local, bool exposureKnown, double modelNoise) {
    const Index count = Index(end - begin), components = at.jacobian[0].cols();
    const MatrixX3d values = at.values.middleRows(Index(begin), count);
    const MatrixX3d roots = pixelWeights(values, MatrixX3d::Zero(count, 3), modelNoise, share).cwiseSqrt();
    Eigen::MatrixXf result(3 * count, local.factor.cols());
    for (Index channel = 0; channel < 3; ++channel) {
      MatrixXd of = at.jacobian[std::size_t(channel)].middleRows(Index(begin), count) *
                    local.factor.middleRows(channel * components, components);
      if (!exposureKnown) of += values.col(channel) * local.factor.bottomRows(1);
      result.middleRows(channel * count, count) = (roots.col(channel).asDiagonal() * of).cast<float>();
    }
    return result;
  }

  std::size_t materials_;
  std::vector<Eigen::MatrixXf> rows_;  ///< [image * materials + material]: channels and regions x unknowns
};

/// The roots of the means of the variances over the materials: of all and of each class.
ExpectedDeviation deviationOf(const VectorXd& variances, const std::vector<std::size_t>& classOf,
                              const std::vector<std::size_t>& materials, std::size_t classes) {
  std::vector<double> sums(classes, 0), counts(classes, 0);
  for (std::size_t m = 0; m < materials.size(); ++m) {
    sums[classOf[materials[m]]] += variances[Index(m)];
    counts[classOf[materials[m]]] += 1;
  }
  ExpectedDeviation result{.overall = std::sqrt(variances.mean()), .classes = {}};
  for (std::size_t c = 0; c < classes; ++c)
    result.classes.push_back(counts[c] > 0 ? std::sqrt(sums[c] / counts[c]) : std::numeric_limits<double>::quiet_NaN());
  return result;
}

double varianceOf(const MatrixXd& normal, const MatrixXd& perCell) {
  return normal.selfadjointView<Eigen::Lower>().llt().solve(perCell).trace();
}

}  // namespace

PhotographPlan planPhotographs(const PhotographPrior& prior, const PhotographSet& set,
                               const std::vector<Photograph>& candidates, const std::vector<std::size_t>& classOf,
                               std::size_t classes, const PlanOptions& options, const TaskControl& control) {
  if (options.images < 1)
    throw Error("found " + std::to_string(options.images) + " images to plan, expected at least 1");
  if (candidates.empty()) throw Error("found no candidate for the next image");
  PhotographPlan plan;
  plan.materials = evenlySpaced(prior.trainingCount(), options.materials);
  PhotographSet all = set;
  all.photographs.insert(all.photographs.end(), candidates.begin(), candidates.end());
  const MatrixX3d noDistances = MatrixX3d::Zero(prior.v.rows(), 3);
  const LocalPrior local = localPrior(prior.v, noDistances, std::numeric_limits<double>::infinity(), set.exposureKnown);
  const Observations observations(prior, all, local, plan.materials, options, control);
  const MatrixXd perCell = variancePerCell(prior, local.factor);
  const std::size_t materials = plan.materials.size(), taken = set.photographs.size();
  std::vector<MatrixXd> normals(materials, MatrixXd::Identity(perCell.rows(), perCell.cols()));
  /// Variances of the materials after the images so far and the image `added`, if there is one.
  const auto variances = [&](std::ptrdiff_t added) {
    VectorXd result(Index(materials), 1);
    parallelForBlocks(materials, 1, [&](std::size_t m, std::size_t) {
      MatrixXd normal = normals[m];
      if (added >= 0) observations.add(std::size_t(added), m, normal);
      result[Index(m)] = varianceOf(normal, perCell);
    });
    return result;
  };
  const auto take = [&](std::size_t image) {
    for (std::size_t m = 0; m < materials; ++m) observations.add(image, m, normals[m]);
  };
  const auto summary = [&](const VectorXd& of) { return deviationOf(of, classOf, plan.materials, classes); };
  plan.before = summary(variances(-1));
  for (std::size_t image = 0; image < taken; ++image) {
    take(image);
    plan.taken.push_back(summary(variances(-1)));
  }
  std::vector<char> used(candidates.size(), 0);
  const std::size_t steps = std::min(std::size_t(options.images), candidates.size());
  while (plan.chosen.size() < steps) {
    const bool isFirst = plan.chosen.empty();
    std::size_t best = candidates.size();
    ExpectedDeviation least;
    for (std::size_t candidate = 0; candidate < candidates.size(); ++candidate) {
      if (used[candidate] != 0) continue;
      control.throwIfStopped();
      const ExpectedDeviation found = summary(variances(std::ptrdiff_t(taken + candidate)));
      if (isFirst) plan.candidates.push_back(found);
      if (best < candidates.size() && !(found.overall < least.overall)) continue;
      best = candidate;
      least = found;
    }
    used[best] = 1;
    take(taken + best);
    plan.chosen.push_back(best);
    plan.after.push_back(least);
    control.report(0.7 + 0.3 * double(plan.chosen.size()) / double(steps));
  }
  return plan;
}

}  // namespace gonio::photograph
