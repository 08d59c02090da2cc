// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/alternatives/k_svd.h"

#include <algorithm>
#include <limits>
#include <random>
#include <string>

#include "core/math/matching_pursuit.h"
#include "core/math/parallel.h"
#include "core/support/error.h"

namespace gonio::dictionary {

namespace {

using Eigen::Index;

/// Power iterations per update: the next iteration of K-SVD continues from the result.
constexpr int powerIterations = 4;
/// Minimum |cosine| of atoms that count as equal.
constexpr double nearlyEqual = 0.99;
constexpr std::size_t patience = 5;

/// A signal that uses an atom, and the position of the atom in its code.
struct Use {
  Index signal;
  std::size_t position;
};

class Learner {
 public:
  Learner(const Eigen::MatrixXd& signals, const KSvdOptions& options)
      : signals_(signals), options_(options), residual_(signals), codes_(std::size_t(signals.cols())) {
    start();
  }

  /// One iteration; returns the squared error after it. @throws Cancelled, without a change of the atoms.
  double iterate(const TaskControl& control) {
    taken_.assign(std::size_t(signals_.cols()), 0);
    replaceDuplicates();
    code(control);
    std::vector<std::vector<Use>> uses(std::size_t(atoms_.cols()));
    for (Index s = 0; s < signals_.cols(); ++s)
      for (std::size_t position = 0; position < codes_[std::size_t(s)].atoms.size(); ++position)
        uses[std::size_t(codes_[std::size_t(s)].atoms[position])].push_back({s, position});
    for (Index k = 0; k < atoms_.cols(); ++k) {
      if (uses[std::size_t(k)].empty())
        replace(k);
      else
        update(k, uses[std::size_t(k)]);
    }
    return residual_.squaredNorm();
  }
  const Eigen::MatrixXd& atoms() const { return atoms_; }

 private:
  /// Initial atoms: different signals, chosen by the seed.
  void start() {
    std::vector<Index> candidates;
    for (Index s = 0; s < signals_.cols(); ++s)
      if (signals_.col(s).squaredNorm() > 0) candidates.push_back(s);
    if (Index(candidates.size()) < options_.atoms)
      throw Error("K-SVD: found " + std::to_string(candidates.size()) + " signals other than 0, expected at least " +
                  std::to_string(options_.atoms) + ", one per atom");
    std::mt19937_64 random(options_.seed);
    atoms_.resize(signals_.rows(), options_.atoms);
    for (Index k = 0; k < options_.atoms; ++k) {
      std::swap(candidates[std::size_t(k)],
                candidates[std::size_t(k) + random() % (candidates.size() - std::size_t(k))]);
      atoms_.col(k) = signals_.col(candidates[std::size_t(k)]).normalized();
    }
  }

  void code(const TaskControl& control) {
    const AtomSet atoms(atoms_);
    const BatchPursuit pursuit(atoms);
    constexpr std::size_t block = 64;
    const auto pursue = [&](std::size_t begin, std::size_t end) {
      std::ranges::move(pursuit.code(signals_, Index(begin), Index(end), {.steps = options_.sparsity}),
                        codes_.begin() + std::ptrdiff_t(begin));
      for (std::size_t s = begin; s < end; ++s) {
        const auto signal = Index(s);
        residual_.col(signal) = signals_.col(signal);
        for (std::size_t position = 0; position < codes_[s].atoms.size(); ++position)
          residual_.col(signal) -= codes_[s].coefficients[position] * atoms_.col(codes_[s].atoms[position]);
      }
    };
    parallelForBlocks(codes_.size(), block, pursue, control);
  }

  void update(Index k, const std::vector<Use>& uses) {
    Eigen::VectorXd atom = atoms_.col(k), coefficients{Index(uses.size())};
    Eigen::MatrixXd left(signals_.rows(), coefficients.size());
    for (Index i = 0; i < coefficients.size(); ++i) {
      const auto [signal, position] = uses[std::size_t(i)];
      coefficients[i] = codes_[std::size_t(signal)].coefficients[position];
      left.col(i) = residual_.col(signal) + coefficients[i] * atom;
    }
    for (int iteration = 0; iteration < powerIterations; ++iteration) {
      const Eigen::VectorXd next = left * coefficients;
      if (!(next.squaredNorm() > 0)) break;
      atom = next.normalized();
      coefficients = left.transpose() * atom;
    }
    atoms_.col(k) = atom;
    for (Index i = 0; i < coefficients.size(); ++i) {
      const auto [signal, position] = uses[std::size_t(i)];
      codes_[std::size_t(signal)].coefficients[position] = coefficients[i];
      residual_.col(signal) = left.col(i) - coefficients[i] * atom;
    }
  }

  void replaceDuplicates() {
    const Eigen::MatrixXd cosines = (atoms_.transpose() * atoms_).cwiseAbs();
    for (Index k = 1; k < atoms_.cols(); ++k)
      if (cosines.col(k).head(k).maxCoeff() > nearlyEqual) replace(k);
  }

  void replace(Index k) {
    Index worst = -1;
    double largest = 0;
    for (Index s = 0; s < signals_.cols(); ++s) {
      const double error = residual_.col(s).squaredNorm();
      if (taken_[std::size_t(s)] == 0 && error > largest) {
        worst = s;
        largest = error;
      }
    }
    if (worst < 0) return;
    taken_[std::size_t(worst)] = 1;
    atoms_.col(k) = signals_.col(worst).normalized();
  }

  const Eigen::MatrixXd& signals_;
  KSvdOptions options_;
  Eigen::MatrixXd atoms_, residual_;
  std::vector<PursuitResult> codes_;
  std::vector<char> taken_;  // signals that became atoms in this iteration
};

void check(const Eigen::MatrixXd& signals, const KSvdOptions& options) {
  if (options.atoms < 1 || options.sparsity < 1 || options.iterations < 1)
    throw Error("K-SVD: the numbers of atoms, of atoms per signal and of iterations must be at least 1");
  for (Index s = 0; s < signals.cols(); ++s)
    if (!signals.col(s).allFinite())
      throw Error("K-SVD: signal " + std::to_string(s) + " has a value that is not finite");
}

/// Whether the last iterations reduced the smallest error by less than the tolerance.
bool converged(const std::vector<double>& errors, double tolerance) {
  if (errors.size() <= patience) return false;
  const auto last = errors.end() - std::ptrdiff_t(patience);
  const double before = *std::min_element(errors.begin(), last), now = *std::min_element(last, errors.end());
  return !(before - now > tolerance * before);
}

}  // namespace

KSvdResult learnKSvd(const Eigen::MatrixXd& signals, const KSvdOptions& options, const TaskControl& control) {
  check(signals, options);
  const double energy = signals.squaredNorm();
  Learner learner(signals, options);
  KSvdResult result;
  double smallest = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < options.iterations && !converged(result.errors, options.tolerance); ++iteration) {
    try {
      const double begin = double(iteration) / options.iterations, end = double(iteration + 1) / options.iterations;
      result.errors.push_back(learner.iterate(control.between(begin, end)) / energy);
    } catch (const Cancelled&) {
      if (iteration == 0) throw;
      result.complete = false;
      break;
    }
    if (result.errors.back() < smallest) {
      smallest = result.errors.back();
      result.atoms = learner.atoms();
    }
  }
  return result;
}

}  // namespace gonio::dictionary
