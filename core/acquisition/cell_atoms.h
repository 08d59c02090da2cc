// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/dictionary/principal_components.h"

namespace gonio::acquisition {

/// The atoms of the simultaneous pursuit, one per candidate cell: the columns of D^-1 = Sigma_p^-1 U_p^T, the left
/// inverse of the scaled basis D = U Sigma of the first p components, normalised to unit length. A zero column stays
/// zero and has score 0. Rows are indices into the basis' mapping; atoms are indices into these rows. Unrelated to the
/// atoms of a dictionary::Dictionary.
class CellAtoms {
 public:
  /// @param components 1 or more. @param rows ascending. The basis must outlive this object.
  CellAtoms(const dictionary::PrincipalComponents& basis, int components, std::vector<std::size_t> rows);

  Eigen::Index count() const { return Eigen::Index(rows_.size()); }
  Eigen::Index length() const { return inverseSigma_.size(); }
  std::size_t row(Eigen::Index atom) const { return rows_[std::size_t(atom)]; }
  /// The atom in double precision, computed from the basis: equal rows give bitwise equal atoms.
  Eigen::VectorXd exact(Eigen::Index atom) const { return column(row(atom)).stableNormalized(); }
  /// The atoms [begin, end) in single precision, p x (end - begin): exact() up to a few units in the last place.
  Eigen::MatrixXf inSinglePrecision(Eigen::Index begin, Eigen::Index end) const;

 private:
  Eigen::VectorXd column(std::size_t row) const;

  const dictionary::PrincipalComponents& basis_;
  Eigen::VectorXd inverseSigma_;  // scaled by the smallest sigma, which the normalisation cancels
  std::vector<std::size_t> rows_;
};

}  // namespace gonio::acquisition
