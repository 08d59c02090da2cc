// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/principal_components.h"

#include <algorithm>
#include <atomic>
#include <string>

#include "core/brdf/data_transform.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

constexpr std::size_t evaluatedCells = 2048;

void checkGrid(const MappedCells& mapping, const HalfDifferenceGrid& grid) {
  if (grid == mapping.grid) return;
  const auto text = [](const HalfDifferenceGrid& g) {
    return std::to_string(g.thetaHCount) + " x " + std::to_string(g.thetaDCount) + " x " + std::to_string(g.phiDCount);
  };
  throw Error("a table of " + text(grid) + " cells does not match the grid of the principal components, " +
              text(mapping.grid));
}

/// Calls work(begin, end, block): `block` the mapped values less the mean of a block of cells, one column a channel.
template <typename Work>
void forEachMappedBlock(const PrincipalComponents& pca, const TabulatedBrdf& table, const TaskControl& control,
                        const Work& work) {
  const MappedCells& m = pca.mapping;
  parallelForBlocks(
      m.cells.size(), evaluatedCells,
      [&](std::size_t begin, std::size_t end) {
        Eigen::MatrixX3d block = Eigen::MatrixX3d::Zero(Eigen::Index(end - begin), 3);
        for (std::size_t i = begin; i < end; ++i) {
          if (!table.valid()[m.cells[i]]) continue;
          for (int channel = 0; channel < 3; ++channel)
            block(Eigen::Index(i - begin), channel) =
                logRelative(table.values()[m.cells[i]][channel], m.weights[i], m.reference[i]) - pca.mean[i];
        }
        work(begin, end, block);
      },
      control);
}

}  // namespace

std::vector<float> leftOutVariance(const PrincipalComponents& pca, int components, std::size_t begin, std::size_t end) {
  const double signals = double(std::max<Eigen::Index>(1, pca.svd.v.rows()));
  std::vector<double> sums(end - begin, 0.0);
  if (!pca.leftOut.empty()) std::copy_n(pca.leftOut.begin() + std::ptrdiff_t(begin), sums.size(), sums.begin());
  const auto u = pca.svd.u.view();
  for (Eigen::Index k = components; k < pca.count(); ++k) {
    const double variance = pca.svd.singularValues[k] * pca.svd.singularValues[k] / signals;
    for (std::size_t i = begin; i < end; ++i) {
      const double entry = u(Eigen::Index(i), k);
      sums[i - begin] += variance * entry * entry;
    }
  }
  return {sums.begin(), sums.end()};
}

std::size_t PrincipalComponents::bytes(int components) const {
  constexpr std::size_t meanAndReference = 2;
  return mean.size() * (std::size_t(components) + meanAndReference) * sizeof(float);
}

ComponentCode ComponentCode::truncated(int components) const {
  ComponentCode result = *this;
  for (Eigen::VectorXf& channel : result.channels)
    channel.conservativeResize(std::min<Eigen::Index>(components, channel.size()));
  return result;
}

ComponentCode ComponentCode::inHalfPrecision() const {
  ComponentCode result = *this;
  for (Eigen::VectorXf& channel : result.channels) {
    const float scale = channel.size() > 0 ? channel.cwiseAbs().maxCoeff() : 0;
    if (scale > 0) channel = (channel / scale).cast<Eigen::half>().cast<float>() * scale;
  }
  return result;
}

std::size_t ComponentCode::halfBytes(int components) {
  return 3 * (sizeof(float) + std::size_t(components) * sizeof(Eigen::half));
}

ComponentCode encode(const PrincipalComponents& pca, const TabulatedBrdf& table, int components,
                     const TaskControl& control) {
  checkGrid(pca.mapping, table.grid());
  const Eigen::Index count = std::clamp(components, 0, pca.count());
  const auto u = pca.svd.u.view().leftCols(count);
  std::vector<Eigen::MatrixX3d> sums((pca.mapping.cells.size() + evaluatedCells - 1) / evaluatedCells);
  forEachMappedBlock(pca, table, control, [&](std::size_t begin, std::size_t end, const Eigen::MatrixX3d& block) {
    sums[begin / evaluatedCells] =
        u.middleRows(Eigen::Index(begin), Eigen::Index(end - begin)).cast<double>().transpose() * block;
  });
  Eigen::MatrixX3d total = Eigen::MatrixX3d::Zero(count, 3);
  for (const Eigen::MatrixX3d& sum : sums) total += sum;
  ComponentCode code;
  for (int channel = 0; channel < 3; ++channel) code.channels[std::size_t(channel)] = total.col(channel).cast<float>();
  return code;
}

std::shared_ptr<const TabulatedBrdf> tableOfCells(const MappedCells& mapping, std::span<const glm::vec3> values) {
  std::vector<TabulatedBrdf::Value> all(mapping.grid.size(), TabulatedBrdf::Value(0));
  std::vector<std::uint8_t> valid(mapping.grid.size(), 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    all[mapping.cells[i]] = values[i];
    valid[mapping.cells[i]] = 1;
  }
  return std::make_shared<const TabulatedBrdf>(mapping.grid, std::move(all), std::move(valid));
}

std::shared_ptr<const TabulatedBrdf> decode(const PrincipalComponents& pca, const ComponentCode& code,
                                            const TaskControl& control, std::size_t* cappedCount) {
  if (code.components() > pca.count())
    throw Error("found " + std::to_string(code.components()) + " coefficients per channel, expected at most " +
                std::to_string(pca.count()) + ", the number of principal components");
  const MappedCells& m = pca.mapping;
  const auto u = pca.svd.u.view().leftCols(code.components());
  Eigen::MatrixX3d coefficients(code.components(), 3);
  for (int channel = 0; channel < 3; ++channel)
    coefficients.col(channel) = code.channels[std::size_t(channel)].cast<double>();
  std::vector<TabulatedBrdf::Value> values(m.grid.size(), TabulatedBrdf::Value(0));
  std::vector<std::uint8_t> valid(m.grid.size(), 0);
  std::atomic<std::size_t> capped = 0;
  parallelForBlocks(
      m.cells.size(), evaluatedCells,
      [&](std::size_t begin, std::size_t end) {
        // In double: of a small value, the inverse mapping amplifies the rounding error of y.
        const Eigen::MatrixX3d block =
            u.middleRows(Eigen::Index(begin), Eigen::Index(end - begin)).cast<double>() * coefficients;
        std::size_t cappedHere = 0;
        for (std::size_t i = begin; i < end; ++i) {
          valid[m.cells[i]] = 1;
          for (int channel = 0; channel < 3; ++channel) {
            const double y = double(pca.mean[i]) + block(Eigen::Index(i - begin), channel);
            const double rho = inverseLogRelative(y, m.weights[i], m.reference[i]);
            cappedHere += rho == maxBrdfValue;
            values[m.cells[i]][channel] = float(rho);
          }
        }
        capped += cappedHere;
      },
      control);
  if (cappedCount) *cappedCount = capped;
  return std::make_shared<const TabulatedBrdf>(m.grid, std::move(values), std::move(valid));
}

}  // namespace gonio::dictionary
