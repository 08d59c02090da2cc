// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/dictionary/largest_coefficients.h"
#include "core/dictionary/mode_products.h"
#include "core/support/task_control.h"

namespace gonio::dictionary {

/// Learns one ensemble of K orthonormal dictionaries at one sparsity (dissertation eq. 4.36). In a round every signal
/// goes to the dictionary that leaves the least error; then, some times over with the memberships kept, each signal
/// keeps its largest coefficients (the exact minimiser, since the dictionaries are orthonormal) and each mode of each
/// dictionary is renewed by orthogonal Procrustes (Schoenemann 1966). No step raises the error, and none reconstructs a
/// signal: the error is the signal's energy less that of its coefficients. A pass with kept memberships projects each
/// signal on one dictionary instead of all K, and most signals stay where they are anyway.
///
/// Same bits for any number of threads.
template <typename Scalar>
class EnsembleLearner {
 public:
  /// @param signals one a column, count(sizes) long; must live on. Columns of 0 are allowed.
  EnsembleLearner(const Matrix<Scalar>& signals, const Sizes& sizes, int dictionaries, int sparsity);

  /// Dictionaries from the higher-order SVD of random parts of the signals.
  void start(std::uint64_t seed, const TaskControl& control = {});
  /// Dictionaries of an earlier run.
  void start(std::vector<ModeMatrices<double>> dictionaries);

  /// One round: the memberships, then `passes` over the dictionaries. Returns the relative squared error of the
  /// dictionaries before it, with the memberships made anew.
  /// @throws Cancelled with the dictionaries as they were.
  double iterate(const TaskControl& control = {}, int passes = 1);
  /// The relative squared error with the memberships made anew, without a change of the dictionaries.
  double assign(const TaskControl& control = {});

  const std::vector<ModeMatrices<double>>& dictionaries() const { return dictionaries_; }
  /// Of each signal: its dictionary.
  std::span<const int> memberships() const { return memberships_; }
  /// Of each signal: squared error.
  std::span<const double> errors() const { return errors_; }
  int sparsity() const { return sparsity_; }

 private:
  using Coefficients = std::vector<Coefficient<Scalar>>;
  std::vector<std::vector<int>> members() const;
  ModeMatrices<double> leadingVectors(std::span<const int> members, const TaskControl& control) const;
  void keepCoefficients(const std::vector<ModeMatrices<double>>& dictionaries, const TaskControl& control);
  void renew(int mode, const std::vector<std::vector<int>>& members, std::vector<ModeMatrices<double>>& dictionaries,
             const TaskControl& control) const;
  void reseedEmpty(const std::vector<std::vector<int>>& members, std::vector<ModeMatrices<double>>& dictionaries,
                   const TaskControl& control) const;

  const Matrix<Scalar>& signals_;
  Sizes sizes_;
  int sparsity_;
  std::vector<double> energies_;
  double totalEnergy_ = 0;
  std::vector<ModeMatrices<double>> dictionaries_;
  std::vector<int> memberships_;
  std::vector<double> errors_;
  std::vector<Coefficients> coefficients_;
};

extern template class EnsembleLearner<float>;
extern template class EnsembleLearner<double>;

}  // namespace gonio::dictionary
