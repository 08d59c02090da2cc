// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/dictionary/dictionary.h"
#include "core/dictionary/largest_projections.h"
#include "core/dictionary/training_materials.h"
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
/// A signal of two parts is represented as the encoder does it (inBothOrders()): by one dictionary, and by the largest
/// coefficients of both parts together.
///
/// Results are bitwise equal for any number of threads.
class EnsembleLearner {
 public:
  /// The parts of a signal as in forEachSignal().
  using Signal = std::vector<CompactSignal<double>>;

  /// @param signals of `sizes`; signals that are 0 are allowed; must outlive this object.
  EnsembleLearner(std::span<const Signal> signals, const Sizes& sizes, int dictionaries, int sparsity);

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
  using Coefficients = std::vector<std::vector<Coefficient<double>>>;  ///< of the parts of a signal
  /// The largest coefficients of a signal over a dictionary.
  void select(const Signal& signal, const ModeMatrices<double>& dictionary, Workspace<double>& workspace,
              Coefficients& selected) const;
  std::vector<std::vector<int>> members() const;
  ModeMatrices<double> leadingVectors(std::span<const int> members, const TaskControl& control) const;
  void selectCoefficients(const std::vector<ModeMatrices<double>>& dictionaries, const TaskControl& control);
  void renew(int mode, const std::vector<std::vector<int>>& members, std::vector<ModeMatrices<double>>& dictionaries,
             const TaskControl& control) const;
  void reseedEmpty(const std::vector<std::vector<int>>& members, std::vector<ModeMatrices<double>>& dictionaries,
                   const TaskControl& control) const;

  std::span<const Signal> signals_;
  Sizes sizes_;
  int sparsity_;
  double totalEnergy_ = 0;
  std::vector<ModeMatrices<double>> dictionaries_;
  std::vector<int> memberships_;
  std::vector<double> errors_;
  std::vector<Coefficients> coefficients_;  ///< of each signal
};

struct TrainingOptions {
  int dictionaries = 8;  ///< K of each ensemble
  /// One ensemble each (Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition",
  /// section 4.3.2.2: 4 ensembles of 8).
  std::vector<int> sparsities{32, 64, 128, 256};
  SignalOptions signals;
  int iterations = 24;         ///< maximum number of rounds per ensemble
  int passes = 4;              ///< per round, with fixed memberships (EnsembleLearner)
  double tolerance = 5e-4;     ///< an ensemble is finished when a round lowers its error by less than this fraction
  double subspaceLoss = 3e-5;  ///< fraction of the energy that the shared subspace may leave out
  bool fullSweep = true;       ///< whether a last sweep in the whole space follows
  std::uint64_t seed = 1;
};

/// State of an unfinished training, from which it continues with bitwise equal results.
struct TrainingState {
  SharedSubspace subspace;
  /// Dictionaries in the subspace, one entry per ensemble that was started; the last one may be unfinished.
  std::vector<std::vector<ModeMatrices<double>>> ensembles;
  /// Relative squared errors before each round, one list per ensemble that was started.
  std::vector<std::vector<double>> errors;
};

struct TrainingResult {
  Ensemble ensemble;
  TrainingState state;
  bool complete = true;              ///< false if the training was stopped
  std::vector<double> errorsBefore;  ///< relative squared error of the dictionaries of each sparsity in the whole
                                     ///< space, before the last sweep
  std::vector<double> errorsAfter;   ///< the same after it
  double seconds = 0;
};

/// Learns the dictionaries of all sparsities: finds a shared subspace, learns each ensemble in it (EnsembleLearner),
/// then makes one sweep in the whole space. A material with both orders of the directions has signals of two parts; the
/// others teach the same dictionaries as without it, bit for bit, if there is none. If it is stopped, returns the
/// dictionaries so far, with `complete` false.
/// @param resume state to continue from, of the same materials and options.
/// @param checkpoint called after each round with the state.
/// @throws Cancelled if stopped before there is a dictionary; Error if there are no materials.
/// Memory: the signals as small blocks (822 signals of 137 materials: about 0.3 GB), and a few tables.
TrainingResult train(const TrainingMaterials& materials, const TrainingOptions& options,
                     const TaskControl& control = {}, const TrainingState* resume = nullptr,
                     const std::function<void(const TrainingState&)>& checkpoint = {});

}  // namespace gonio::dictionary
