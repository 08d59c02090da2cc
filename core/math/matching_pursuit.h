// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

/// Greedy sparse approximation of a signal as a sum of few columns of a matrix, the atoms. In double precision, on one
/// thread; callers process several signals in parallel.
namespace gonio {

/// The atoms of a pursuit, of any norm; zero atoms are never chosen.
class AtomSet {
 public:
  /// @throws Error that names the first atom with a value that is not finite.
  explicit AtomSet(Eigen::MatrixXd atoms);

  const Eigen::MatrixXd& matrix() const { return atoms_; }
  Eigen::Index count() const { return atoms_.cols(); }
  Eigen::Index length() const { return atoms_.rows(); }
  /// 1 / |atom|; 0 for a zero atom.
  double inverseNorm(Eigen::Index atom) const { return inverseNorms_[atom]; }

 private:
  Eigen::MatrixXd atoms_;
  Eigen::VectorXd inverseNorms_;
};

struct PursuitOptions {
  int steps = 1;            ///< maximum number of atoms, one per step
  double residual = 1e-10;  ///< stops when the residual's norm is this fraction of the signal's
};

enum class PursuitEnd {
  steps,     ///< all steps were done
  residual,  ///< the residual is small enough; immediately for a zero signal
  exhausted  ///< no remaining atom reduces the residual, although it is not small
};

struct PursuitResult {
  std::vector<int> atoms;            ///< distinct, in the order of choice
  std::vector<double> coefficients;  ///< one per atom, for atoms that are not normalised
  double residualNorm = 0;           ///< |signal - sum of coefficient times atom|
  std::vector<double> path;  ///< residualNorm before the first step and after each; a pursuit of fewer steps is a
                             ///< prefix of this one
  PursuitEnd end = PursuitEnd::residual;
};

/// Orthogonal matching pursuit (Pati et al. 1993): each step chooses the atom with the largest |<residual, atom>| /
/// |atom|, the lowest index among equals, from those outside the span of the chosen atoms; then all coefficients are
/// solved by least squares (core/math/decompositions.h). The residual never increases. At most AtomSet::length() atoms
/// are chosen. O(atoms x length) per step. @throws Error if the signal has another length than the atoms or is not
/// finite.
PursuitResult orthogonalMatchingPursuit(const AtomSet& atoms, const Eigen::Ref<const Eigen::VectorXd>& signal,
                                        const PursuitOptions& options);

/// The same pursuit of many signals over one set of atoms: a step updates the correlations of the residual with the
/// atoms from the Gram matrix instead of computing them from the residual (Rubinstein, Zibulevsky and Elad 2008,
/// "Efficient Implementation of the K-SVD Algorithm using Batch Orthogonal Matching Pursuit"). The codes are those of
/// orthogonalMatchingPursuit(), except where rounding decides between atoms.
class BatchPursuit {
 public:
  /// Keeps a reference. Cost: O(atoms^2 length); memory: 8 atoms^2 bytes.
  explicit BatchPursuit(const AtomSet& atoms);

  /// The codes of the signals begin to end - 1, the columns of `signals`. @param residuals PursuitOptions::residual of
  /// each of these signals; empty: that of the options. O(atoms x length) per signal and O(atoms x steps) per step; the
  /// bits depend on begin and end, since the correlations of all signals are one matrix product. @throws Error as
  /// orthogonalMatchingPursuit().
  std::vector<PursuitResult> code(const Eigen::MatrixXd& signals, Eigen::Index begin, Eigen::Index end,
                                  const PursuitOptions& options, std::span<const double> residuals = {}) const;

 private:
  const AtomSet& atoms_;
  Eigen::MatrixXd gram_;
};

}  // namespace gonio
