// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <vector>

namespace gonio::factorization {

/// A three-mode tensor with weights, which are 0 in cells without data; the last index runs fastest.
struct MaskedTensor {
  int sizes[3] = {0, 0, 0};
  std::vector<float> values;   ///< finite; ignored where the weight is 0
  std::vector<float> weights;  ///< of the squared error per cell, >= 0

  std::size_t index(int i, int j, int k) const {
    return (std::size_t(i) * std::size_t(sizes[1]) + std::size_t(j)) * std::size_t(sizes[2]) + std::size_t(k);
  }
  /// Weighted sum of squares.
  double squaredNorm() const;
};

/// The rank-one tensor a o b o c. The largest absolute entry of b and c is 1; `a` contains the scale.
struct RankOne {
  std::vector<double> a, b, c;
  std::vector<double> residuals;  ///< weighted squared norm of the residual at the start and after each sweep; never
                                  ///< increases
};

struct RankOneOptions {
  /// All factors are >= 0: each update of an entry is the exact minimum under this bound.
  bool nonnegative = false;
  int maxSweeps = 60;
  double tolerance = 1e-6;  ///< stops when a sweep lowers the residual by less than this fraction
};

/// The rank-one tensor of least weighted squared error, by alternating least squares in closed form: a_i = sum_jk w x
/// b_j c_k / sum_jk w b_j^2 c_k^2, then b and c likewise; 0 where all weights are 0. Starts with marginal means
/// (non-negative) or with the fibres through the largest entry. Deterministic, parallel. Two passes over the tensor per
/// sweep.
RankOne bestRankOne(const MaskedTensor& tensor, const RankOneOptions& options = {});

/// Subtracts a o b o c.
void subtract(MaskedTensor& tensor, const RankOne& term);

}  // namespace gonio::factorization
