// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/simultaneous_pursuit.h"

#include <cmath>

#include "core/acquisition/atom_scores.h"
#include "core/math/decompositions.h"
#include "core/math/parallel.h"

namespace gonio::acquisition {

namespace {

/// The residual's fraction of the signals that rounding leaves of 0.
constexpr double explained = 1e-10;

/// The one of the largest score in double, the lowest index among equals.
Eigen::Index best(const std::vector<Eigen::Index>& candidates, const CellAtoms& atoms, const PursuitSpace& space) {
  std::vector<double> scores(candidates.size());
  parallelForBlocks(candidates.size(), 1, [&](std::size_t i, std::size_t) {
    const Eigen::VectorXd left = space.remainderOf(atoms.exact(candidates[i]));
    // One product an atom, so that equal atoms have equal scores to the last bit.
    scores[i] = (space.signals.transpose() * left).lpNorm<1>();
  });
  return candidates[std::size_t(std::max_element(scores.begin(), scores.end()) - scores.begin())];
}

/// |S^T a|_1 <= gain |a|.
double gain(const Eigen::MatrixXd& signals) {
  const double largest = eigenBasis(signals * signals.transpose()).values[0];
  constexpr double rounding = 1 + 1e-6;
  return rounding * std::sqrt(largest * double(signals.cols()));
}

}  // namespace

SimultaneousPursuitResult simultaneousPursuit(const CellAtoms& atoms, const Eigen::MatrixXd& signals, int samples,
                                              const TaskControl& control,
                                              const std::function<void(Eigen::Index atom)>& chosen) {
  SimultaneousPursuitResult result;
  PursuitSpace space(signals);
  const double norm = signals.norm();
  result.residuals.push_back(norm > 0 ? 1 : 0);
  if (!(norm > 0)) {
    result.stop = PursuitStop::explained;
    return result;
  }
  AtomScores scores(atoms, gain(signals));
  while (int(result.atoms.size()) < samples) {
    if (result.residuals.back() <= explained) {
      result.stop = PursuitStop::explained;
      break;
    }
    const std::vector<Eigen::Index> candidates = scores.candidates(space, {control.stop, {}});
    const Eigen::Index atom = candidates.empty() ? -1 : best(candidates, atoms, space);
    const Eigen::VectorXd left = atom < 0 ? Eigen::VectorXd() : space.remainderOf(atoms.exact(atom));
    // No score is far below its atom's length outside the span, so with the best all others are in the span.
    if (!(left.norm() > IncrementalQr::collinear)) {
      result.stop = PursuitStop::exhausted;
      break;
    }
    scores.exclude(atom);
    space.remove(left);
    result.atoms.push_back(atom);
    result.residuals.push_back(std::min(result.residuals.back(), space.signals.norm() / norm));
    if (chosen) chosen(atom);
    control.report(double(result.atoms.size()) / samples);
  }
  return result;
}

}  // namespace gonio::acquisition
