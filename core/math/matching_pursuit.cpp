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

/// @param correlationOf <atom, residual> of an atom.
template <typename CorrelationOf>
Choice bestAtom(const AtomSet& atoms, const std::vector<char>& excluded, const CorrelationOf& correlationOf) {
  Choice best;
  for (Eigen::Index atom = 0; atom < atoms.count(); ++atom) {
    if (excluded[std::size_t(atom)]) continue;
    const double correlation = correlationOf(atom) * atoms.inverseNorm(atom);
    if (std::abs(correlation) > std::abs(best.correlation)) best = {atom, correlation};
  }
  return best;
}

/// Correlations from the residual.
class DirectCorrelations {
 public:
  explicit DirectCorrelations(const AtomSet& atoms) : atoms_(atoms) {}

  Choice best(const Eigen::VectorXd& residual, const std::vector<char>& excluded) const {
    // One sum an atom, so that equal atoms have equal correlations to the last bit.
    return bestAtom(atoms_, excluded, [&](Eigen::Index atom) { return atoms_.matrix().col(atom).dot(residual); });
  }
  void subtract(double, Eigen::Index, const IncrementalQr&) {}

 private:
  const AtomSet& atoms_;
};

/// Correlations that follow the residual by the Gram matrix: those with the columns q of Q are combinations of its
/// columns.
class GramCorrelations {
 public:
  GramCorrelations(const AtomSet& atoms, const Eigen::MatrixXd& gram, Eigen::VectorXd correlations, Eigen::Index most)
      : atoms_(atoms), gram_(gram), correlations_(std::move(correlations)), withQ_(atoms.count(), most) {}

  Choice best(const Eigen::VectorXd&, const std::vector<char>& excluded) const {
    return bestAtom(atoms_, excluded, [&](Eigen::Index atom) { return correlations_[atom]; });
  }
  /// The residual has lost `projection` times the newest column of Q, which `atom` has added.
  void subtract(double projection, Eigen::Index atom, const IncrementalQr& qr) {
    // Below this fraction of the atom's length outside the span, the combination loses too many digits.
    constexpr double nearlyDependent = 1e-2;
    const Eigen::Index newest = qr.size() - 1;
    const double outside = qr.r()(newest, newest);
    if (std::abs(outside) * atoms_.inverseNorm(atom) > nearlyDependent)
      withQ_.col(newest) = (gram_.col(atom) - withQ_.leftCols(newest) * qr.r().col(newest).head(newest)) / outside;
    else
      withQ_.col(newest) = atoms_.matrix().transpose() * qr.q().col(newest);
    correlations_ -= projection * withQ_.col(newest);
  }

 private:
  const AtomSet& atoms_;
  const Eigen::MatrixXd& gram_;
  Eigen::VectorXd correlations_;
  Eigen::MatrixXd withQ_;  ///< atoms^T Q
};

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

/// The number of atoms that a pursuit may choose.
Eigen::Index maxAtoms(const AtomSet& atoms, const PursuitOptions& options) {
  return std::min<Eigen::Index>({atoms.count(), atoms.length(), std::max(0, options.steps)});
}

template <typename Correlations>
PursuitResult pursue(const AtomSet& atoms, const Eigen::Ref<const Eigen::VectorXd>& signal,
                     const PursuitOptions& options, Correlations correlations) {
  Eigen::VectorXd residual = signal;
  const double norm = residual.norm();
  const Eigen::Index most = maxAtoms(atoms, options);
  IncrementalQr qr(atoms.length(), most);
  Eigen::VectorXd projections(most);  // of the signal on the columns of Q
  std::vector<char> excluded(std::size_t(atoms.count()), 0);
  PursuitResult code{.residualNorm = norm, .path = {norm}};
  while (!ended(options, norm, code)) {
    const Choice best = correlations.best(residual, excluded);
    if (std::abs(best.correlation) <= noise * norm) {
      code.end = PursuitEnd::exhausted;
      break;
    }
    excluded[std::size_t(best.atom)] = 1;
    if (!qr.append(atoms.matrix().col(best.atom))) continue;
    const auto newest = qr.q().rightCols<1>();
    const double projection = newest.col(0).dot(residual);
    residual -= projection * newest.col(0);
    correlations.subtract(projection, best.atom, qr);
    projections[qr.size() - 1] = projection;
    code.atoms.push_back(int(best.atom));
    code.residualNorm = std::min(code.residualNorm, residual.norm());
    code.path.push_back(code.residualNorm);
  }
  const Eigen::VectorXd coefficients = qr.solve(projections.head(qr.size()));
  code.coefficients.assign(coefficients.begin(), coefficients.end());
  return code;
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
  return pursue(atoms, signal, options, DirectCorrelations(atoms));
}

BatchPursuit::BatchPursuit(const AtomSet& atoms) : atoms_(atoms), gram_(atoms.matrix().transpose() * atoms.matrix()) {}

std::vector<PursuitResult> BatchPursuit::code(const Eigen::MatrixXd& signals, Eigen::Index begin, Eigen::Index end,
                                              const PursuitOptions& options, std::span<const double> residuals) const {
  for (Eigen::Index s = begin; s < end; ++s) checkSignal(atoms_, signals.col(s));
  const Eigen::MatrixXd correlations = atoms_.matrix().transpose() * signals.middleCols(begin, end - begin);
  std::vector<PursuitResult> codes;
  for (Eigen::Index s = 0; s < end - begin; ++s) {
    PursuitOptions own = options;
    if (!residuals.empty()) own.residual = residuals[std::size_t(s)];
    codes.push_back(pursue(atoms_, signals.col(begin + s), own,
                           GramCorrelations(atoms_, gram_, correlations.col(s), maxAtoms(atoms_, own))));
  }
  return codes;
}

}  // namespace gonio
