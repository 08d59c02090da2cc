// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>

namespace gonio::acquisition {

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

}  // namespace gonio::acquisition
