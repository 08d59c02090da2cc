// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/support/task_control.h"

namespace gonio {

/// A matrix in single precision with many rows and few columns, column after column: gigabytes, so it is moved, never
/// copied.
struct TallMatrix {
  std::vector<float> values;
  Eigen::Index rows = 0, columns = 0;

  Eigen::Map<const Eigen::MatrixXf> view() const { return {values.data(), rows, columns}; }
  Eigen::Map<Eigen::MatrixXf> view() { return {values.data(), rows, columns}; }
};

/// T = U Sigma V^T of a tall matrix without the components that are too weak to be distinguished from rounding.
struct GramSvd {
  TallMatrix u;                    ///< orthonormal columns, in single precision
  Eigen::VectorXd singularValues;  ///< descending, > 0
  Eigen::MatrixXd v;               ///< T's columns x components, orthonormal; the largest entry of a column is positive
};

/// T^T T in double, accumulated over blocks of rows; deterministic for any number of threads. rows x columns^2
/// multiplications at the rate of Eigen's symmetric product, in parallel.
/// @throws Cancelled.
Eigen::MatrixXd gramMatrix(const TallMatrix& matrix, const TaskControl& control = {});

/// The thin singular value decomposition by the eigenvectors of the Gram matrix (Sirovich 1987, the method of
/// snapshots). That squares the condition number: components with sigma <= 1e-6 of the largest are dropped, and U is
/// orthonormal to 1e-16 (sigma_1 / sigma)^2 and to single precision. U takes the memory of T.
/// @param maxComponents the strongest that are kept. @throws Cancelled.
GramSvd decomposeGramSvd(TallMatrix matrix, int maxComponents, const TaskControl& control = {});

}  // namespace gonio
