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
  int sparsity = 4;         ///< maximum number of atoms per signal
  int iterations = 50;      ///< maximum
  double tolerance = 1e-3;  ///< ends when five iterations reduce the smallest error by less than this fraction
  std::uint64_t seed = 1;
};

struct KSvdResult {
  Eigen::MatrixXd atoms;       ///< columns of unit length: those of the iteration with the smallest error
  std::vector<double> errors;  ///< relative squared error after each iteration
  bool complete = true;        ///< false after a stop: the best so far
};

/// Learns one unstructured dictionary by K-SVD (Aharon, Elad and Bruckstein 2006, "K-SVD: An Algorithm for Designing
/// Overcomplete Dictionaries for Sparse Representation"). Each iteration encodes every signal by orthogonal matching
/// pursuit; then each atom in turn, with its coefficients, is replaced by the first singular pair of the residual of
/// the signals that use it, by power iteration from the present atom. An atom that no signal uses, or that is nearly
/// equal to another one, is replaced by the signal with the largest residual. Updates of atoms never increase the
/// error; matching pursuit can, because it does not find the optimum if signals use several atoms.
///
/// The dictionary consists of length x atoms numbers; a dictionary of an ensemble consists of n0^2 + n1^2 + n2^2, n the
/// sizes of the modes. Same bits for any number of threads. An iteration is O(signals x sparsity x atoms x length).
/// @param signals one per column; some may be 0. @throws Error if fewer signals than atoms differ from 0, a value is
/// not finite, or a count is below 1; Cancelled if stopped in the first iteration.
KSvdResult learnKSvd(const Eigen::MatrixXd& signals, const KSvdOptions& options, const TaskControl& control = {});

}  // namespace gonio::dictionary
