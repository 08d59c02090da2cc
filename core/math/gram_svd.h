// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/support/task_control.h"

namespace gonio {

/// A column-major matrix in single precision with many rows and few columns. Move it, since it may have gigabytes.
struct TallMatrix {
  std::vector<float> values;
  Eigen::Index rows = 0, columns = 0;

  Eigen::Map<const Eigen::MatrixXf> view() const { return {values.data(), rows, columns}; }
  Eigen::Map<Eigen::MatrixXf> view() { return {values.data(), rows, columns}; }
};

/// T = U Sigma V^T of a tall matrix, without components that cannot be distinguished from rounding errors.
struct GramSvd {
  TallMatrix u;                    ///< orthonormal columns, in single precision
  Eigen::VectorXd singularValues;  ///< descending, > 0
  Eigen::MatrixXd v;               ///< columns of T x components, orthonormal; with the signs of EigenBasis
};

/// T^T T in double, accumulated over blocks of rows; deterministic for any number of threads. rows x columns^2
/// multiplications by Eigen's symmetric product, in parallel. @throws Cancelled.
Eigen::MatrixXd gramMatrix(const TallMatrix& matrix, const TaskControl& control = {});

/// Adds the products of a block of rows to the lower triangle of `gram` = T^T T, a square matrix with as many columns
/// as the block. Parallel over tiles of the result, so that one matrix suffices however many columns there are;
/// deterministic. Memory: 8 bytes per value of the block. @throws Cancelled.
void addToGram(Eigen::MatrixXd& gram, const TallMatrix& block, const TaskControl& control = {});

/// Singular values and V from the lower triangle of T^T T; `u` remains empty. Components are dropped as in
/// decomposeGramSvd(), at most `maxComponents` remain.
GramSvd decomposeGram(const Eigen::MatrixXd& gram, int maxComponents);
/// The rows of U that belong to a block of rows of T: T V / Sigma. Parallel over blocks of rows.
Eigen::MatrixXf leftVectors(const GramSvd& svd, const TallMatrix& block, const TaskControl& control = {});

/// The thin singular value decomposition by the eigenvectors of the Gram matrix (Sirovich 1987, the method of
/// snapshots). The Gram matrix squares the condition number, so components with sigma <= 1e-6 of the largest are
/// dropped, and U is orthonormal to 1e-16 (sigma_1 / sigma)^2 and single precision. U reuses the memory of T.
/// @param maxComponents maximum number of components; the strongest remain. @throws Cancelled.
GramSvd decomposeGramSvd(TallMatrix matrix, int maxComponents, const TaskControl& control = {});

}  // namespace gonio
