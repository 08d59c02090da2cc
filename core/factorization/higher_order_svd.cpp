// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/higher_order_svd.h"

#include <cassert>

#include "core/math/decompositions.h"

namespace gonio::factorization {

Eigen::MatrixXd leadingSingularVectors(const Tensor& tensor, int mode, int count) {
  assert(count >= 1 && count <= tensor.size(mode));
  const Eigen::MatrixXd fibres = unfold(tensor, mode);
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(fibres.rows(), fibres.rows());
  gram.selfadjointView<Eigen::Lower>().rankUpdate(fibres);
  return eigenBasis(gram).vectors.leftCols(count);
}

HigherOrderSvd decomposeHigherOrderSvd(const Tensor& tensor, const std::vector<int>& ranks) {
  assert(int(ranks.size()) == tensor.modes());
  HigherOrderSvd result{.core = tensor, .factors = {}};
  for (int mode = 0; mode < tensor.modes(); ++mode) {
    result.factors.push_back(leadingSingularVectors(tensor, mode, ranks[std::size_t(mode)]));
    result.core = transposedModeProduct(result.core, result.factors.back(), mode);
  }
  return result;
}

Tensor compose(const HigherOrderSvd& decomposition) {
  Tensor result = decomposition.core;
  for (std::size_t mode = 0; mode < decomposition.factors.size(); ++mode)
    result = modeProduct(result, decomposition.factors[mode], int(mode));
  return result;
}

}  // namespace gonio::factorization
