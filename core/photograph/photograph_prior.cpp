// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/photograph_prior.h"

#include <algorithm>
#include <cmath>

#include "core/brdf/data_transform.h"
#include "core/math/decompositions.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::photograph {

using Eigen::Index, Eigen::MatrixXd, Eigen::MatrixX3d, Eigen::VectorXd;

namespace {

/// The step between the nodes of one axis, of which about `wanted` remain; a divisor of the count.
int stepOf(int count, int wanted) {
  int step = std::max(1, count / wanted);
  while (count % step != 0) --step;
  return step;
}

/// What is known of the logarithm of an unknown exposure beforehand: its standard deviation.
constexpr double exposureSpread = 3;

/// The orders in which the channels of a training material stand for red, green and blue: the colour of a material says
/// little about its highlights, while its channels are alike.
constexpr int channelOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

}  // namespace

PhotographPrior photographPrior(const dictionary::PrincipalComponents& basis, int components) {
  constexpr int thetaDNodes = 30, phiDNodes = 36;
  const HalfDifferenceGrid& fine = basis.mapping.grid;
  if (!fine.reciprocal) throw Error("photographs need principal components of reciprocal materials");
  const int stepD = stepOf(fine.thetaDCount, thetaDNodes), stepPhi = stepOf(fine.phiDCount, phiDNodes);
  PhotographPrior prior;
  HalfDifferenceGrid& grid = prior.mapping.grid;
  grid = {fine.thetaHCount, fine.thetaDCount / stepD, fine.phiDCount / stepPhi, true};
  std::vector<std::size_t> chosen;  // places in basis.mapping.cells
  for (std::size_t i = 0; i < basis.mapping.cells.size(); ++i) {
    const std::size_t cell = basis.mapping.cells[i];
    const int phi = int(cell % std::size_t(fine.phiDCount)), row = int(cell / std::size_t(fine.phiDCount));
    const int thetaD = row % fine.thetaDCount, thetaH = row / fine.thetaDCount;
    if (phi % stepPhi != 0 || thetaD % stepD != 0) continue;
    chosen.push_back(i);
    prior.mapping.cells.push_back(std::uint32_t(grid.index(thetaH, thetaD / stepD, phi / stepPhi)));
    prior.mapping.weights.push_back(basis.mapping.weights[i]);
    prior.mapping.reference.push_back(basis.mapping.reference[i]);
  }
  const Index used = std::min<Index>(components, basis.count());
  prior.v = basis.svd.v.leftCols(used);
  prior.singularValues = basis.svd.singularValues.head(used);
  const auto rows = Index(chosen.size());
  prior.d.resize(rows, used);
  prior.mean.resize(rows);
  const auto u = basis.svd.u.view();
  const Eigen::RowVectorXf singular = basis.svd.singularValues.head(used).cast<float>().transpose();
  parallelForBlocks(chosen.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      prior.d.row(Index(i)) = u.row(Index(chosen[i])).head(used).cwiseProduct(singular);
      prior.mean[Index(i)] = basis.mean[chosen[i]];
    }
  });
  return prior;
}

std::vector<glm::vec3> cellValues(const PhotographPrior& prior, const MatrixX3d& coefficients,
                                  std::vector<glm::vec3>* slopes) {
  const std::size_t cells = prior.mapping.cells.size();
  std::vector<glm::vec3> values(cells);
  if (slopes) slopes->resize(cells);
  const Eigen::MatrixX3f c = coefficients.cast<float>();
  parallelForBlocks(cells, 2048, [&](std::size_t begin, std::size_t end) {
    const Eigen::MatrixX3f y = prior.d.middleRows(Index(begin), Index(end - begin)) * c;
    for (std::size_t i = begin; i < end; ++i) {
      const double weight = prior.mapping.weights[i], reference = prior.mapping.reference[i];
      for (int channel = 0; channel < 3; ++channel) {
        constexpr double highest = 30;  // e^30 is far beyond any material
        const double mapped = std::min(highest, double(prior.mean[Index(i)]) + y(Index(i - begin), channel));
        values[i][channel] = float(inverseLogRelative(mapped, weight, reference));
        if (slopes) (*slopes)[i][channel] = float((reference + logRelativeOffset) * std::exp(mapped) / weight);
      }
    }
  });
  return values;
}

std::array<MatrixXd, 3> signalImages(const PhotographPrior& prior, const PixelRows& rows, const TaskControl& control) {
  constexpr Index block = 32;
  const Index signals = prior.v.rows();
  std::array<MatrixXd, 3> images;
  for (MatrixXd& image : images) image.resize(Index(rows.count()), signals);
  for (Index first = 0; first < signals; first += block) {
    control.throwIfStopped();
    const Index count = std::min(block, signals - first);
    const Eigen::MatrixXf coefficients = prior.v.middleRows(first, count).transpose().cast<float>();
    RowMatrix values(prior.d.rows(), count);
    parallelForBlocks(std::size_t(prior.d.rows()), 2048, [&](std::size_t begin, std::size_t end) {
      auto part = values.middleRows(Index(begin), Index(end - begin));
      part = prior.d.middleRows(Index(begin), Index(end - begin)) * coefficients;
      for (std::size_t i = begin; i < end; ++i) {
        const float weight = prior.mapping.weights[i], reference = prior.mapping.reference[i],
                    offset = float(logRelativeOffset);
        auto row = values.row(Index(i)).array();
        row = (((row + prior.mean[Index(i)]).exp() * (reference + offset) - offset) / weight).max(0.0f);
      }
    });
    parallelForBlocks(rows.count(), 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row) {
        std::array<Eigen::RowVectorXf, 3> sums;
        for (auto& sum : sums) sum.setZero(count);
        for (std::size_t n = rows.first[row]; n < rows.first[row + 1]; ++n) {
          const auto of = values.row(Index(rows.cells[n]));
          for (int channel = 0; channel < 3; ++channel) sums[std::size_t(channel)] += rows.weights[n][channel] * of;
        }
        for (std::size_t channel = 0; channel < 3; ++channel)
          images[channel].row(Index(row)).segment(first, count) = sums[channel].cast<double>().array().max(1e-12).log();
      }
    });
  }
  return images;
}

MatrixX3d signalDistances(const std::array<MatrixXd, 3>& images, const MatrixX3d& values, const MatrixX3d& variances) {
  MatrixX3d distances = MatrixX3d::Zero(images[0].cols(), channelCount);
  for (Index channel = 0; channel < channelCount; ++channel) {
    const MatrixXd& image = images[std::size_t(channel)];
    double count = 0;
    for (Index row = 0; row < image.rows(); ++row) {
      if (!(values(row, channel) > 0)) continue;
      const VectorXd of = image.row(row).transpose();
      const double known = variances(row, channel) / (values(row, channel) * values(row, channel));
      const double variance = (of.array() - of.mean()).square().mean() + known;
      if (!(variance > 0)) continue;
      distances.col(channel) += ((of.array() - std::log(values(row, channel))).square() / variance).matrix();
      ++count;
    }
    if (count > 0) distances.col(channel) /= count;
  }
  return distances;
}

LocalPrior localPrior(const MatrixXd& v, const MatrixX3d& distances, double bandwidth, bool exposureKnown) {
  constexpr double leastSum = 2;  // of the weights of all training materials; the most similar one has 1
  const Index materials = v.rows() / channelCount, components = v.cols(), count = 6 * materials;
  const Index coefficients = channelCount * components, unknowns = coefficients + (exposureKnown ? 0 : 1);
  MatrixXd samples(count, coefficients);
  VectorXd of(count);
  for (Index m = 0; m < materials; ++m)
    for (Index order = 0; order < 6; ++order) {
      const Index row = 6 * m + order;
      of[row] = 0;
      for (Index channel = 0; channel < channelCount; ++channel) {
        const Index signal = channelCount * m + channelOrders[order][channel];
        samples.row(row).segment(channel * components, components) = v.row(signal);
        of[row] += distances(signal, channel) / double(channelCount);
      }
    }
  VectorXd weights = VectorXd::Ones(count);
  if (std::isfinite(bandwidth))
    weights = (-(of.array() - of.minCoeff()) / (2 * bandwidth * bandwidth)).exp().max(leastSum / double(count));
  weights /= weights.sum();
  LocalPrior prior{VectorXd::Zero(unknowns), {}};
  prior.mean.head(coefficients) = samples.transpose() * weights;
  samples.rowwise() -= prior.mean.head(coefficients).transpose().eval();
  const MatrixXd scaled = weights.cwiseSqrt().asDiagonal() * samples;
  const EigenBasis basis = eigenBasis(scaled.transpose() * scaled);
  prior.factor = MatrixXd::Zero(unknowns, unknowns);
  prior.factor.topLeftCorner(coefficients, coefficients) =
      basis.vectors * basis.values.cwiseMax(0).cwiseSqrt().asDiagonal();
  if (!exposureKnown) prior.factor(coefficients, coefficients) = exposureSpread;
  return prior;
}

}  // namespace gonio::photograph
