// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/photograph/pixel_model.h"

#include <algorithm>
#include <limits>

#include "core/math/parallel.h"

namespace gonio::photograph {

using Eigen::Index, Eigen::MatrixXd, Eigen::MatrixX3d;

PixelLinearisation linearised(const PhotographPrior& prior, const PixelRows& rows, const MatrixX3d& coefficients,
                              const TaskControl& control) {
  std::vector<glm::vec3> slopes;
  const std::vector<glm::vec3> values = cellValues(prior, coefficients, &slopes);
  const Index count = Index(rows.count()), components = prior.d.cols();
  PixelLinearisation result;
  result.values.resize(count, channelCount);
  for (MatrixXd& of : result.jacobian) of.resize(count, components);
  parallelForBlocks(rows.count(), 16,
                    [&](std::size_t begin, std::size_t end) {
                      std::array<Eigen::RowVectorXf, 3> sums;
                      for (std::size_t row = begin; row < end; ++row) {
                        Rgb value(0);
                        for (auto& sum : sums) sum.setZero(components);
                        for (std::size_t n = rows.first[row]; n < rows.first[row + 1]; ++n) {
                          const std::uint32_t cell = rows.cells[n];
                          value += Rgb(rows.weights[n] * values[cell]);
                          const glm::vec3 factor = rows.weights[n] * slopes[cell];
                          const auto d = prior.d.row(Index(cell));
                          sums[0] += factor.x * d;
                          sums[1] += factor.y * d;
                          sums[2] += factor.z * d;
                        }
                        for (Index channel = 0; channel < channelCount; ++channel) {
                          result.values(Index(row), channel) = value[int(channel)];
                          result.jacobian[std::size_t(channel)].row(Index(row)) =
                              sums[std::size_t(channel)].cast<double>();
                        }
                      }
                    },
                    {control.stop, {}});
  return result;
}

MatrixX3d pixelValues(const PhotographPrior& prior, const PixelRows& rows, const MatrixX3d& coefficients) {
  const std::vector<Rgb> values = rows.values(cellValues(prior, coefficients));
  MatrixX3d result(Index(values.size()), channelCount);
  for (std::size_t row = 0; row < values.size(); ++row)
    for (int channel = 0; channel < 3; ++channel) result(Index(row), channel) = values[row][channel];
  return result;
}

std::vector<std::size_t> evenlySpaced(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0, n = std::min(count, most); i < n; ++i) chosen.push_back(i * count / n);
  return chosen;
}

double sharedInformation(std::span<const Photograph> photographs, std::size_t rows) {
  constexpr double independentRegions = 25, ofFlatSample = 1;
  double sum = 0;
  for (const Photograph& of : photographs)
    sum += std::holds_alternative<FlatSample>(of.surface) ? ofFlatSample : independentRegions;
  return std::min(1.0, sum / double(rows));
}

MatrixX3d pixelWeights(const MatrixX3d& values, const MatrixX3d& noise, double modelNoise, double share) {
  constexpr double ofMean = 0.05;  // dark pixels are not more accurate than this part of the mean
  MatrixX3d variances = noise;
  for (Index channel = 0; channel < channelCount; ++channel) {
    const double base = ofMean * values.col(channel).cwiseAbs().mean();
    variances.col(channel).array() +=
        (modelNoise * (values.col(channel).array().abs() + base)).square() + std::numeric_limits<double>::min();
  }
  return share * variances.cwiseInverse();
}

}  // namespace gonio::photograph
