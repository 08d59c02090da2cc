// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/acquisition/cell_atoms.h"
#include "core/acquisition/pursuit_space.h"
#include "core/support/task_control.h"

namespace gonio::acquisition {

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
