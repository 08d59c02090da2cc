// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <vector>

namespace gonio::factorization {

/// A three-mode tensor of which only some cells count, some more than others; the last index runs fastest.
struct MaskedTensor {
  int sizes[3] = {0, 0, 0};
  std::vector<float> values;   ///< finite; of no meaning in cells that do not count
  std::vector<float> weights;  ///< of the squared error of a cell, >= 0; 0 where it does not count

  std::size_t index(int i, int j, int k) const {
    return (std::size_t(i) * std::size_t(sizes[1]) + std::size_t(j)) * std::size_t(sizes[2]) + std::size_t(k);
  }
  /// Weighted sum of squares.
  double squaredNorm() const;
};

/// The rank-one tensor a o b o c; b and c have a largest entry of 1 in size, so that `a` carries the strength.
struct RankOne {
  std::vector<double> a, b, c;
  std::vector<double> residuals;  ///< weighted sum of squares left, at the start and after each sweep: never rises
};

struct RankOneOptions {
  bool nonnegative = false;  ///< for values that are not negative: all factors stay >= 0 at no cost
  int maxSweeps = 60;
  double tolerance = 1e-6;  ///< relative fall of the residual below which it stops
};

/// The rank-one tensor of least weighted squared error, by alternating least squares in closed form:
/// a_i = sum_jk w x b_j c_k / sum_jk w b_j^2 c_k^2, cyclic; 0 where no cell counts. Starts from marginal means
/// (non-negative) or from the fibres through the largest entry. Deterministic; in parallel. Two passes a sweep.
RankOne bestRankOne(const MaskedTensor& tensor, const RankOneOptions& options = {});

/// Takes a o b o c away.
void subtract(MaskedTensor& tensor, const RankOne& term);

}  // namespace gonio::factorization
