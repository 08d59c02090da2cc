// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/support/task_control.h"

namespace gonio::dictionary {

struct KSvdOptions {
  int atoms = 256;
  int sparsity = 4;         ///< atoms a signal may use
  int iterations = 50;      ///< rounds at most
  double tolerance = 1e-3;  ///< done when five rounds lower the least error by less than this fraction
  std::uint64_t seed = 1;
};

struct KSvdResult {
  Eigen::MatrixXd atoms;       ///< columns of unit length: those of the round with the least error
  std::vector<double> errors;  ///< relative squared error after each round
  bool complete = true;        ///< false after a stop: the best so far
};

/// K-SVD: Aharon, Elad and Bruckstein 2006, "K-SVD: An Algorithm for Designing Overcomplete Dictionaries for Sparse
/// Representation". Round by round every signal is coded by orthogonal matching pursuit; then each atom in turn, with
/// its coefficients, becomes the first singular pair of what the other atoms leave of the signals that use it, by power
/// iteration from where it is. An atom that nobody uses, or that is nearly another one, becomes the signal that is
/// served worst. Renewing atoms never raises the error; a pursuit may, since it is no exact minimiser but where signals
/// use one atom.
///
/// The classical baseline of one unstructured dictionary: it stores length x atoms numbers, where the ensemble's
/// dictionaries store the squares of three sides. Same bits for any number of threads. A round costs signals x sparsity
/// x atoms x length.
/// @param signals one a column; some may be 0. @throws Error when there are fewer signals other than 0 than atoms, when
/// one is not finite, or for a count below 1; Cancelled when stopped in the first round.
KSvdResult learnKSvd(const Eigen::MatrixXd& signals, const KSvdOptions& options, const TaskControl& control = {});

}  // namespace gonio::dictionary
