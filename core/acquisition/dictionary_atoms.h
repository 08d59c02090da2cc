// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/dictionary/principal_components.h"

namespace gonio::acquisition {

/// What each cell says about a code: the columns of D^-1 = Sigma_p^-1 U_p^T, the left inverse of the dictionary of the
/// first p components, at unit length; a column of 0 stays 0, and its score with it. Rows are indices into the basis'
/// mapping, atoms into these rows.
class DictionaryAtoms {
 public:
  /// @param components 1 or more. @param rows ascending. The basis must outlive this.
  DictionaryAtoms(const dictionary::PrincipalComponents& basis, int components, std::vector<std::size_t> rows);

  Eigen::Index count() const { return Eigen::Index(rows_.size()); }
  Eigen::Index length() const { return inverseSigma_.size(); }
  std::size_t row(Eigen::Index atom) const { return rows_[std::size_t(atom)]; }
  /// In double, straight from the basis: equal rows give equal bits.
  Eigen::VectorXd exact(Eigen::Index atom) const { return column(row(atom)).stableNormalized(); }
  /// The atoms [begin, end) in single precision, p x (end - begin): rounded from exact() but for a few last digits.
  Eigen::MatrixXf inSinglePrecision(Eigen::Index begin, Eigen::Index end) const;

 private:
  Eigen::VectorXd column(std::size_t row) const;

  const dictionary::PrincipalComponents& basis_;
  Eigen::VectorXd inverseSigma_;  // times the smallest sigma: atoms have unit length anyway
  std::vector<std::size_t> rows_;
};

}  // namespace gonio::acquisition
