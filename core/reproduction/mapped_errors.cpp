// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/reproduction/mapped_errors.h"

#include <cmath>
#include <limits>

#include "core/brdf/data_transform.h"
#include "core/math/parallel.h"

namespace gonio::reproduction {

namespace {

constexpr std::size_t mappedBlock = 2048;

}  // namespace

MappedMaterials::MappedMaterials(const dictionary::PrincipalComponents& basis,
                                 std::span<const std::shared_ptr<const TabulatedBrdf>> tables)
    : basis_(basis), values_(Eigen::Index(basis.mapping.cells.size()), Eigen::Index(3 * tables.size())) {
  const dictionary::MappedCells& m = basis.mapping;
  parallelForBlocks(m.cells.size(), mappedBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = 0; t < tables.size(); ++t)
      for (std::size_t i = begin; i < end; ++i)
        for (int channel = 0; channel < 3; ++channel)
          values_(Eigen::Index(i), Eigen::Index(3 * t) + channel) =
              float(logRelative(tables[t]->values()[m.cells[i]][channel], m.weights[i], m.reference[i]));
  });
}

std::vector<double> MappedMaterials::inverseErrors(std::span<const dictionary::ComponentCode> codes,
                                                   const TaskControl& control) const {
  const dictionary::MappedCells& m = basis_.mapping;
  const Eigen::Index components = codes.empty() ? 0 : codes.front().components();
  Eigen::MatrixXf coefficients(components, values_.cols());
  for (std::size_t t = 0; t < codes.size(); ++t)
    for (int channel = 0; channel < 3; ++channel)
      coefficients.col(Eigen::Index(3 * t) + channel) = codes[t].channels[std::size_t(channel)];
  const auto u = basis_.svd.u.view().leftCols(components);
  // A sum for each block, added in order, so that the number of threads does not matter.
  Eigen::ArrayXXd sums((Eigen::Index(m.cells.size()) + mappedBlock - 1) / mappedBlock, values_.cols());
  parallelForBlocks(
      m.cells.size(), mappedBlock,
      [&](std::size_t begin, std::size_t end) {
        const Eigen::Index first = Eigen::Index(begin), rows = Eigen::Index(end - begin);
        Eigen::ArrayXf mean(rows), black(rows);
        for (Eigen::Index i = 0; i < rows; ++i) {
          mean[i] = basis_.mean[begin + std::size_t(i)];
          black[i] = float(logRelative(0, m.weights[begin + std::size_t(i)], m.reference[begin + std::size_t(i)]));
        }
        const Eigen::MatrixXf decoded = u.middleRows(first, rows) * coefficients;
        for (Eigen::Index column = 0; column < values_.cols(); ++column)
          sums(Eigen::Index(begin / mappedBlock), column) =
              (values_.col(column).segment(first, rows).array() - (decoded.col(column).array() + mean).max(black))
                  .square()
                  .cast<double>()
                  .sum();
      },
      control);
  std::vector<double> result;
  for (std::size_t t = 0; t < codes.size(); ++t) {
    const double sum = sums.middleCols(Eigen::Index(3 * t), 3).sum();
    result.push_back(sum > 0 ? 3 * double(m.cells.size()) / sum : std::numeric_limits<double>::quiet_NaN());
  }
  return result;
}

}  // namespace gonio::reproduction
