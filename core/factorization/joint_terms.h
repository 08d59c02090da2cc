// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/factorization/masked_rank_one.h"
#include "core/support/task_control.h"

namespace gonio::factorization {

struct JointOptions {
  bool firstNonnegative = false;  ///< the factors of the first term remain >= 0; they must be so at the start
  int maxSweeps = 60;
  double tolerance = 1e-4;  ///< stops when a sweep lowers the squared norm by less than this fraction
};

/// Improves the terms of a weighted CP decomposition together: alternating least squares of the weighted squared error
/// (Kolda and Bader 2009, "Tensor Decompositions and Applications", section 3.4, with a weight per cell). All entries
/// of one mode are solved exactly for fixed other modes, index by index: L equations for L terms. A small proximal term
/// limits the change where the equations are singular, and the condition that the factors of the first product are >= 0
/// (JointOptions::firstNonnegative) is met exactly, so the error never increases. Entries without any weighted cell are
/// not changed.
///
/// Afterwards the largest absolute entry of b and c of each term is 1. RankOne::residuals is not changed. In double,
/// deterministic, on one thread; callers process channels in parallel. O(cells L^2) per sweep: 50 ms for ten terms of
/// 90 x 90 x 180 cells, and 16 bytes per cell. Returns the weighted squared norm of the residual at the start and after
/// each sweep. @throws Cancelled.
std::vector<double> refineJointly(const MaskedTensor& tensor, std::vector<RankOne>& terms,
                                  const JointOptions& options = {}, const TaskControl& control = {});

}  // namespace gonio::factorization
