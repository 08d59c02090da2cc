// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>

namespace gonio::dictionary {

/// The orthogonal matrix U that maximises trace(U^T Z), square: W V^T of Z = W Sigma V^T (Schoenemann 1966, "A
/// generalized solution of the orthogonal Procrustes problem"). Orthonormal up to rounding for any rank of Z, also for
/// Z = 0.
Eigen::MatrixXd orthogonalProcrustes(const Eigen::MatrixXd& z);

}  // namespace gonio::dictionary
