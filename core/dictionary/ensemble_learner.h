// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/dictionary/compact_signal.h"
#include "core/dictionary/largest_coefficients.h"
#include "core/support/task_control.h"

namespace gonio::dictionary {

/// Learns one ensemble of K orthonormal dictionaries at one sparsity (Tongbuasirilai 2023, "Data-Driven Approaches for
/// Sparse Reflectance Modeling and Acquisition", eq. 4.36). Each round assigns every signal to the dictionary with the
/// smallest error. Then, in one or more passes with fixed memberships, each signal is represented by its largest
/// coefficients (the exact minimiser, because the dictionaries are orthonormal) and each mode of each dictionary is
/// updated by orthogonal Procrustes (Schoenemann 1966). No step increases the error. Signals are never reconstructed:
/// the error is the signal's energy minus that of its coefficients. Passes with fixed memberships are cheaper, as they
/// project each signal onto one dictionary instead of K.
///
/// Results are bitwise equal for any number of threads.
class EnsembleLearner {
 public:
  /// @param signals of `sizes`; signals that are 0 are allowed; must outlive this object.
  EnsembleLearner(std::span<const CompactSignal<double>> signals, const Sizes& sizes, int dictionaries, int sparsity);

  /// Divides the signals at random into as many parts of equal size as there are dictionaries, and initialises each
  /// dictionary with the higher-order SVD of one part.
  void start(std::uint64_t seed, const TaskControl& control = {});
  /// Starts with the dictionaries of an earlier run.
  void start(std::vector<ModeMatrices<double>> dictionaries);

  /// One round: updates the memberships, then makes `passes` passes. Returns the relative squared error of the new
  /// memberships with the dictionaries before the passes. @throws Cancelled; the dictionaries are then unchanged.
  double iterate(const TaskControl& control = {}, int passes = 1);
  /// Updates only the memberships and returns the relative squared error.
  double assign(const TaskControl& control = {});

  const std::vector<ModeMatrices<double>>& dictionaries() const { return dictionaries_; }
  /// Index of each signal's dictionary.
  std::span<const int> memberships() const { return memberships_; }
  /// Squared error of each signal.
  std::span<const double> errors() const { return errors_; }
  int sparsity() const { return sparsity_; }

 private:
  using Coefficients = std::vector<Coefficient<double>>;
  std::vector<std::vector<int>> members() const;
  ModeMatrices<double> leadingVectors(std::span<const int> members, const TaskControl& control) const;
  void selectCoefficients(const std::vector<ModeMatrices<double>>& dictionaries, const TaskControl& control);
  void renew(int mode, const std::vector<std::vector<int>>& members, std::vector<ModeMatrices<double>>& dictionaries,
             const TaskControl& control) const;
  void reseedEmpty(const std::vector<std::vector<int>>& members, std::vector<ModeMatrices<double>>& dictionaries,
                   const TaskControl& control) const;

  std::span<const CompactSignal<double>> signals_;
  Sizes sizes_;
  int sparsity_;
  double totalEnergy_ = 0;
  std::vector<ModeMatrices<double>> dictionaries_;
  std::vector<int> memberships_;
  std::vector<double> errors_;
  std::vector<Coefficients> coefficients_;
};

}  // namespace gonio::dictionary
