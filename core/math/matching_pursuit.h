// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <vector>

/// Greedy sparse approximation: a signal as a sum of few columns of a matrix, its atoms. In double, on one thread:
/// callers run many signals in parallel.
namespace gonio {

/// The columns among which pursuits choose, of any lengths; those of length 0 are never chosen.
class AtomSet {
 public:
  /// @throws Error naming the first atom that is not finite.
  explicit AtomSet(Eigen::MatrixXd atoms);

  const Eigen::MatrixXd& matrix() const { return atoms_; }
  Eigen::Index count() const { return atoms_.cols(); }
  Eigen::Index length() const { return atoms_.rows(); }
  /// 1 / |atom|; 0 of a zero atom.
  double inverseNorm(Eigen::Index atom) const { return inverseNorms_[atom]; }

 private:
  Eigen::MatrixXd atoms_;
  Eigen::VectorXd inverseNorms_;
};

struct PursuitOptions {
  int steps = 1;            ///< atoms that are chosen at most, one per step
  double residual = 1e-10;  ///< the fraction of the signal's norm at which enough is explained
};

enum class PursuitEnd {
  steps,     ///< all steps were made
  residual,  ///< the residual is small enough; a signal of 0 needs no atom
  exhausted  ///< no atom is left that explains anything of the residual, which is not small
};

struct PursuitResult {
  std::vector<int> atoms;            ///< distinct, in the order in which they were chosen
  std::vector<double> coefficients;  ///< one an atom: of the atom as it is, not of unit length
  double residualNorm = 0;           ///< |signal - sum of coefficient times atom|
  std::vector<double> path;          ///< residualNorm before the first step and after each: a pursuit of fewer steps is
                                     ///< the beginning of this one
  PursuitEnd end = PursuitEnd::residual;
};

/// Orthogonal matching pursuit (Pati et al. 1993): each step takes the atom of the largest |<residual, atom>| / |atom|,
/// the lowest index among equals, among the atoms that are not in the span of those chosen; after each step the
/// coefficients of all are those of least squares (core/math/incremental_qr.h). The residual never grows. Ends at the
/// latest with as many atoms as their length. O(atoms x length) a step.
/// @throws Error when the signal's length is not that of the atoms, or it is not finite.
PursuitResult orthogonalMatchingPursuit(const AtomSet& atoms, const Eigen::Ref<const Eigen::VectorXd>& signal,
                                        const PursuitOptions& options);

}  // namespace gonio
