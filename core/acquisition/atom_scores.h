// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/acquisition/dictionary_atoms.h"
#include "core/acquisition/pursuit_space.h"
#include "core/support/task_control.h"

namespace gonio::acquisition {

/// Finds the atoms a of the largest score |R^T a|_1 while the residual R loses one direction after the other, without
/// evaluating most of them. Single precision, with bounds on what rounding can do.
class AtomScores {
 public:
  /// Memory: 4 p bytes an atom. @param gain |S^T a|_1 <= gain |a| for all a.
  AtomScores(const DictionaryAtoms& atoms, double gain);

  /// Those that may have the largest score, ascending: all but atoms proven to be worse than another. To be called once
  /// after each choice, with what it left. @throws Cancelled.
  std::vector<Eigen::Index> candidates(const PursuitSpace& space, const TaskControl& control);
  /// Never again among the candidates.
  void exclude(Eigen::Index atom);

 private:
  /// Neighbouring atoms, in coordinates of `basis_`, and what is known of their scores.
  struct Block {
    Eigen::MatrixXf atoms;
    Eigen::ArrayXf squaredNorm;  ///< of what the choices leave of the atom
    Eigen::ArrayXf score;        ///< when it was evaluated last; huge before, far below 0 of an excluded atom
    Eigen::ArrayXf growth;       ///< by how much it can have risen since: sum of |<removed, a>| reach
    Eigen::ArrayXf normAtScore;  ///< squaredNorm at that time
    Eigen::ArrayXf distance;     ///< from the atom in the middle of its group, or more
    float highest;               ///< the largest bound of the block, as it was seen last
  };
  struct Scan;
  struct BlockScan;

  static void measureDistances(Block& block);
  void update(Block& block, const Scan& scan) const;
  Eigen::ArrayXf bounds(const Block& block, const Scan& scan) const;
  void scoreBlock(Block& block, Scan& scan, std::vector<std::pair<float, Eigen::Index>>& found) const;

  std::vector<Block> blocks_;
  Eigen::MatrixXd basis_;  ///< B: p x d', orthonormal; every complement since it was set lies in its span
  double gain_;
  double coordinateError_;  ///< bound of the rounding in a block's atoms, each as a vector
};

}  // namespace gonio::acquisition
