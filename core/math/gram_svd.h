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
  Eigen::MatrixXd v;  ///< columns of T x components, orthonormal; the largest entry of a column is positive
};

/// T^T T in double, accumulated over blocks of rows; deterministic for any number of threads. rows x columns^2
/// multiplications by Eigen's symmetric product, in parallel. @throws Cancelled.
Eigen::MatrixXd gramMatrix(const TallMatrix& matrix, const TaskControl& control = {});

/// The thin singular value decomposition by the eigenvectors of the Gram matrix (Sirovich 1987, the method of
/// snapshots). The Gram matrix squares the condition number, so components with sigma <= 1e-6 of the largest are
/// dropped, and U is orthonormal to 1e-16 (sigma_1 / sigma)^2 and single precision. U reuses the memory of T.
/// @param maxComponents maximum number of components; the strongest are kept. @throws Cancelled.
GramSvd decomposeGramSvd(TallMatrix matrix, int maxComponents, const TaskControl& control = {});

}  // namespace gonio
