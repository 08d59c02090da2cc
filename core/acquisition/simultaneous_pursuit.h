// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <functional>

#include "core/acquisition/dictionary_atoms.h"
#include "core/support/task_control.h"

namespace gonio::acquisition {

enum class PursuitStop {
  enough,     ///< all samples were chosen
  explained,  ///< the residual is 0 but for rounding
  exhausted   ///< no atom is left that is not in the span of those chosen
};

struct SimultaneousPursuitResult {
  std::vector<Eigen::Index> atoms;  ///< distinct, in the order of choice
  std::vector<double> residuals;    ///< |R| / |S| before the first choice and after each
  PursuitStop stop = PursuitStop::enough;
};

/// Simultaneous orthogonal matching pursuit (Tropp et al. 2006; dissertation, Algorithm 4) of all signals at once: each
/// step takes the atom of the largest sum over the signals of |<atom, residual>|, the lowest index among equals, and
/// the residual becomes what the chosen atoms cannot explain by least squares.
///
/// The choice is that of plain evaluation in double, whatever the number of threads. It is found by bounds: the score
/// of an atom is at most sqrt(t) |S|_2 times the length of what the chosen atoms leave of it, and it rises from one
/// step to the next by at most as much as the chosen direction can add. Only atoms whose bounds reach the best score so
/// far are evaluated, in single precision with proven error bounds, and only those that rounding could make the best in
/// double. Memory: 4 p bytes an atom. Cost: at most samples x p x t x atoms multiplications in single precision.
/// @param signals S, p x t, finite. @throws Cancelled.
SimultaneousPursuitResult simultaneousPursuit(const DictionaryAtoms& atoms, const Eigen::MatrixXd& signals, int samples,
                                              const TaskControl& control = {},
                                              const std::function<void(Eigen::Index atom)>& chosen = {});

}  // namespace gonio::acquisition
