// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/matching_pursuit.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/math/decompositions.h"
#include "core/support/error.h"

namespace gonio {

namespace {

/// A correlation of at most this fraction of the signal's norm is what rounding leaves of 0.
constexpr double noise = 1e-13;

/// The atom that explains most of a residual.
struct Choice {
  Eigen::Index atom = -1;  ///< none
  double correlation = 0;  ///< with the atom at unit length
};

Choice bestAtom(const AtomSet& atoms, const Eigen::VectorXd& residual, const std::vector<char>& excluded) {
  Choice best;
  for (Eigen::Index atom = 0; atom < atoms.count(); ++atom) {
    if (excluded[std::size_t(atom)]) continue;
    // One sum an atom, so that equal atoms have equal correlations to the last bit.
    const double correlation = atoms.matrix().col(atom).dot(residual) * atoms.inverseNorm(atom);
    if (std::abs(correlation) > std::abs(best.correlation)) best = {atom, correlation};
  }
  return best;
}

void checkSignal(const AtomSet& atoms, const Eigen::Ref<const Eigen::VectorXd>& signal) {
  if (signal.size() != atoms.length())
    throw Error("a signal of " + std::to_string(signal.size()) + " values does not match the length of the atoms, " +
                std::to_string(atoms.length()));
  if (!signal.allFinite()) throw Error("a signal has a value that is not a finite number");
}

bool ended(const PursuitOptions& options, double signalNorm, PursuitResult& code) {
  if (code.residualNorm <= options.residual * signalNorm)
    code.end = PursuitEnd::residual;
  else if (int(code.atoms.size()) >= options.steps)
    code.end = PursuitEnd::steps;
  else
    return false;
  return true;
}

}  // namespace

AtomSet::AtomSet(Eigen::MatrixXd atoms) : atoms_(std::move(atoms)), inverseNorms_(atoms_.cols()) {
  for (Eigen::Index atom = 0; atom < count(); ++atom) {
    const double norm = atoms_.col(atom).stableNorm(), inverse = 1 / norm;
    if (!std::isfinite(norm)) throw Error("atom " + std::to_string(atom) + " has a value that is not a finite number");
    inverseNorms_[atom] = std::isfinite(inverse) ? inverse : 0;
  }
}

PursuitResult orthogonalMatchingPursuit(const AtomSet& atoms, const Eigen::Ref<const Eigen::VectorXd>& signal,
                                        const PursuitOptions& options) {
  checkSignal(atoms, signal);
  Eigen::VectorXd residual = signal;
  const double norm = residual.norm();
  const Eigen::Index most = std::min<Eigen::Index>({atoms.count(), atoms.length(), std::max(0, options.steps)});
  IncrementalQr qr(atoms.length(), most);
  Eigen::VectorXd projections(most);  // of the signal on the columns of Q
  std::vector<char> excluded(std::size_t(atoms.count()), 0);
  PursuitResult code{.residualNorm = norm, .path = {norm}};
  while (!ended(options, norm, code)) {
    const Choice best = bestAtom(atoms, residual, excluded);
    if (std::abs(best.correlation) <= noise * norm) {
      code.end = PursuitEnd::exhausted;
      break;
    }
    excluded[std::size_t(best.atom)] = 1;
    if (!qr.append(atoms.matrix().col(best.atom))) continue;
    const auto newest = qr.q().rightCols<1>();
    const double projection = newest.col(0).dot(residual);
    residual -= projection * newest.col(0);
    projections[qr.size() - 1] = projection;
    code.atoms.push_back(int(best.atom));
    code.residualNorm = std::min(code.residualNorm, residual.norm());
    code.path.push_back(code.residualNorm);
  }
  const Eigen::VectorXd coefficients = qr.solve(projections.head(qr.size()));
  code.coefficients.assign(coefficients.begin(), coefficients.end());
  return code;
}

}  // namespace gonio
