// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>

namespace gonio::acquisition {

/// What a pursuit's chosen atoms leave of the signals: the residual is R = N T.
struct PursuitSpace {
  Eigen::MatrixXd complement;  ///< N: p x d, orthonormal: all that is orthogonal to the chosen atoms
  Eigen::MatrixXd signals;     ///< T = N^T S: d x t
  Eigen::VectorXd removed;     ///< the unit direction that the last choice took away; empty before the first
  double reach = 0;            ///< |S^T removed|_1

  /// Before the first choice.
  explicit PursuitSpace(const Eigen::MatrixXd& allSignals);

  /// An atom's coordinates in the complement.
  Eigen::VectorXd left(const Eigen::VectorXd& atom) const { return complement.transpose() * atom; }
  /// Takes the direction of `left` (not 0) away, by a reflection: nothing is solved and no error grows.
  void remove(const Eigen::VectorXd& left);
};

}  // namespace gonio::acquisition
