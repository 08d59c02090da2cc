// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>

#include "core/acquisition/atom_scores.h"
#include "core/support/task_control.h"

namespace gonio::acquisition {

enum class PursuitStop {
  enough,     ///< the requested number of atoms was chosen
  explained,  ///< the residual is 0 up to rounding
  exhausted   ///< all other atoms lie in the span of the chosen ones
};

struct SimultaneousPursuitResult {
  std::vector<Eigen::Index> atoms;  ///< distinct, in the order of choice
  std::vector<double> residuals;    ///< |R| / |S| before the first choice and after each
  PursuitStop stop = PursuitStop::enough;
};

/// Simultaneous orthogonal matching pursuit of all signals (Tropp, Gilbert and Strauss 2006, "Algorithms for
/// Simultaneous Sparse Approximation. Part I: Greedy Pursuit"; Tongbuasirilai 2023, "Data-Driven Approaches for Sparse
/// Reflectance Modeling and Acquisition", Algorithm 4). Each step chooses the atom with the largest sum of |<atom,
/// residual>| over the signals, the lowest index among equals; the residual is what the chosen atoms do not explain by
/// least squares.
///
/// The choice equals that of a plain evaluation in double precision, for any number of threads. Bounds avoid most
/// evaluations: the score of an atom is at most sqrt(t) |S|_2 times the length of its part orthogonal to the chosen
/// atoms, and from one step to the next it rises at most by what the chosen direction can add. Atoms with bounds that
/// reach the best score so far are evaluated in single precision with proven error bounds; only those that could be the
/// best within rounding are evaluated in double. Memory: 4 p bytes per atom. Cost: at most samples x p x t x atoms
/// multiplications in single precision.
/// @param signals S, p x t, finite. @param chosen called with each atom as it is chosen. @throws Cancelled.
SimultaneousPursuitResult simultaneousPursuit(const CellAtoms& atoms, const Eigen::MatrixXd& signals, int samples,
                                              const TaskControl& control = {},
                                              const std::function<void(Eigen::Index atom)>& chosen = {});

}  // namespace gonio::acquisition
