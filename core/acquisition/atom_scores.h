// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/dictionary/principal_components.h"
#include "core/support/task_control.h"

namespace gonio::acquisition {

/// Whether each atom is normalised, as in the authors' code, or all keep their lengths, as Algorithm 4 is printed.
enum class AtomLengths { unit, own };

/// The atoms of the simultaneous pursuit, one per candidate cell: the columns of D^-1 = Sigma_p^-1 U_p^T, the left
/// inverse of the scaled basis D = U Sigma of the first p components, normalised to unit length, or all divided by the
/// length of the longest. A zero column stays zero and has score 0. Rows are indices into the basis' mapping; atoms are
/// indices into these rows. Unrelated to the atoms of a dictionary::Dictionary.
class CellAtoms {
 public:
  /// @param components 1 or more. @param rows ascending. The basis must outlive this object.
  CellAtoms(const dictionary::PrincipalComponents& basis, int components, std::vector<std::size_t> rows,
            AtomLengths lengths = AtomLengths::unit);

  Eigen::Index count() const { return Eigen::Index(rows_.size()); }
  Eigen::Index length() const { return inverseSigma_.size(); }
  std::size_t row(Eigen::Index atom) const { return rows_[std::size_t(atom)]; }
  /// The atom in double precision, computed from the basis: equal rows give bitwise equal atoms.
  Eigen::VectorXd exact(Eigen::Index atom) const {
    return scale_ > 0 ? scale_ * column(row(atom)) : column(row(atom)).stableNormalized();
  }
  /// The atoms [begin, end) in single precision, p x (end - begin): exact() up to a few units in the last place.
  Eigen::MatrixXf inSinglePrecision(Eigen::Index begin, Eigen::Index end) const;

 private:
  Eigen::VectorXd column(std::size_t row) const;

  const dictionary::PrincipalComponents& basis_;
  Eigen::VectorXd inverseSigma_;  // scaled by the smallest sigma, which the normalisation cancels
  double scale_ = 0;              // of all atoms; 0: each is normalised
  std::vector<std::size_t> rows_;
};

/// The residual R = N T of a pursuit: the part of the signals S that is orthogonal to the chosen atoms.
struct PursuitSpace {
  Eigen::MatrixXd complement;  ///< N: p x d, orthonormal basis of the space orthogonal to the chosen atoms
  Eigen::MatrixXd signals;     ///< T = N^T S: d x t
  Eigen::VectorXd removed;     ///< the unit direction that the last choice removed; empty before the first
  double reach = 0;            ///< |S^T removed|_1

  /// The space before the first choice. @param allSignals S, p x t.
  explicit PursuitSpace(const Eigen::MatrixXd& allSignals);

  /// Coordinates of an atom in the complement: its part orthogonal to the chosen atoms.
  Eigen::VectorXd remainderOf(const Eigen::VectorXd& atom) const { return complement.transpose() * atom; }
  /// Removes a direction (coordinates in the complement, not 0) by a Householder reflection, so that rounding errors do
  /// not accumulate.
  void remove(const Eigen::VectorXd& direction);
};

/// Finds the atom a with the largest score |R^T a|_1 at each step of a simultaneous pursuit (simultaneous_pursuit.h),
/// where the residual R loses one direction per step. Bounds on the scores avoid most evaluations. Computes in single
/// precision; the bounds include its rounding error.
class AtomScores {
 public:
  /// Memory: 4 p bytes per atom of length p. @param gain bound of the scores of the signals S: |S^T a|_1 <= gain |a|
  /// for all a.
  AtomScores(const CellAtoms& atoms, double gain);

  /// The atoms that may have the largest score, ascending: all except those proven worse than another atom. Call it
  /// once before each choice, with the space at that time. @throws Cancelled.
  std::vector<Eigen::Index> candidates(const PursuitSpace& space, const TaskControl& control);
  /// Removes an atom from all later candidates.
  void exclude(Eigen::Index atom);

 private:
  /// Neighbouring atoms, in coordinates of `basis_`, and bounds on their scores.
  struct Block {
    Eigen::MatrixXf atoms;
    Eigen::ArrayXf squaredNorm;  ///< of the atom's part orthogonal to the chosen atoms
    Eigen::ArrayXf score;        ///< at its last evaluation; +huge before the first, -huge if excluded
    /// Bound of the increase of the score since then: sum of |<removed, a>| times PursuitSpace::reach.
    Eigen::ArrayXf growth;
    Eigen::ArrayXf squaredNormAtScore;  ///< squaredNorm at that evaluation
    Eigen::ArrayXf distance;            ///< upper bound of the distance to the middle one of 8 neighbouring atoms
    float highest;                      ///< largest score bound of the block at the last scan
  };
  struct Scan;
  struct BlockScan;

  static void measureDistances(Block& block);
  void update(Block& block, const Scan& scan) const;
  Eigen::ArrayXf bounds(const Block& block, const Scan& scan) const;
  void scoreBlock(Block& block, Scan& scan, std::vector<std::pair<float, Eigen::Index>>& found) const;

  std::vector<Block> blocks_;
  Eigen::MatrixXd basis_;  ///< B: p x d', orthonormal; its span contains every complement since it was set
  double gain_;
  double coordinateError_;  ///< bound of the rounding error of a block's atom, as a vector norm
};

}  // namespace gonio::acquisition
