// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/training.h"

#include <chrono>

#include "core/dictionary/ensemble_learner.h"
#include "core/dictionary/full_sweep.h"

namespace gonio::dictionary {

namespace {

/// Fraction of its energy that a signal may omit in the rounds: little beside their errors of 1e-3 or more.
constexpr double signalLoss = 1e-5;
// Fractions of the progress: the passes that find the subspace, the rounds in it, the last sweep.
constexpr double subspaceShare = 0.15, roundsShare = 0.6;

class Training {
 public:
  Training(const TrainingMaterials& materials, const TrainingOptions& options, const TaskControl& control,
           const std::function<void(const TrainingState&)>& checkpoint)
      : materials_(materials), options_(options), control_(control), checkpoint_(checkpoint) {}

  TrainingResult run(const TrainingState* resume) {
    const auto start = std::chrono::steady_clock::now();
    if (resume) result_.state = *resume;
    try {
      findSignals();
      for (std::size_t e = 0; e < options_.sparsities.size(); ++e) learn(e);
      lift();
      if (options_.fullSweep) sweep();
    } catch (const Cancelled&) {
      if (result_.state.ensembles.empty()) throw;
      result_.complete = false;
      lift();
    }
    for (const AssignedEnsemble& ensemble : assigned_)
      for (const ModeMatrices<double>& d : ensemble.dictionaries)
        result_.ensemble.dictionaries.push_back({d, ensemble.sparsity});
    result_.ensemble.grid = materials_.grid;
    result_.ensemble.learnedFrom = materials_.names;
    result_.ensemble.scaled = options_.signals.scaled;
    result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::move(result_);
  }

 private:
  TaskControl part(double begin, double end) const {
    return {.stop = control_.stop,
            .progress = [this, begin, end](double fraction) { control_.report(begin + (end - begin) * fraction); }};
  }

  void findSignals() {
    TrainingState& state = result_.state;
    if (state.ensembles.empty())
      state.subspace =
          findSharedSubspace(materials_, options_.signals, options_.subspaceLoss, part(0, subspaceShare / 2));
    signals_.resize(materials_.names.size() * options_.signals.signalsPerMaterial());
    forEachProjection(
        state.subspace, materials_, options_.signals,
        [&](std::size_t signal, std::span<const double> block) {
          signals_[signal] = compactSignal(block.data(), state.subspace.ranks, signalLoss);
        },
        part(subspaceShare / 2, subspaceShare));
  }

  bool settled(const std::vector<double>& errors) const {
    if (int(errors.size()) >= options_.iterations) return true;
    if (errors.size() < 2) return false;
    const double last = errors.back(), former = errors[errors.size() - 2];
    return former - last <= options_.tolerance * former;
  }

  void learn(std::size_t e) {
    TrainingState& state = result_.state;
    EnsembleLearner learner(std::span<const CompactSignal<double>>(signals_), state.subspace.ranks,
                            options_.dictionaries, options_.sparsities[e]);
    const double each = roundsShare / double(options_.sparsities.size());
    if (e < state.ensembles.size()) {
      learner.start(state.ensembles[e]);
    } else {
      learner.start(options_.seed + e, {.stop = control_.stop});
      state.ensembles.push_back(learner.dictionaries());
      state.errors.emplace_back();
    }
    while (!settled(state.errors[e])) {
      const double error = learner.iterate({.stop = control_.stop}, options_.passes);
      state.errors[e].push_back(error);
      state.ensembles[e] = learner.dictionaries();
      if (checkpoint_) checkpoint_(state);
      const double rounds = double(state.errors[e].size()) / options_.iterations;
      control_.report(subspaceShare + each * (double(e) + std::min(1.0, rounds)));
    }
    learner.assign({.stop = control_.stop});
    memberships_.emplace_back(learner.memberships().begin(), learner.memberships().end());
  }

  void lift() {
    const TrainingState& state = result_.state;
    assigned_.clear();
    for (std::size_t e = 0; e < state.ensembles.size(); ++e) {
      AssignedEnsemble& ensemble = assigned_.emplace_back();
      ensemble.sparsity = options_.sparsities[e];
      if (e < memberships_.size()) ensemble.memberships = memberships_[e];
      for (const ModeMatrices<double>& inner : state.ensembles[e])
        ensemble.dictionaries.push_back(state.subspace.lifted(inner));
    }
  }

  void sweep() {
    const double begin = subspaceShare + roundsShare, end = 0.95;
    result_.errorsBefore = sweepFullSpace(assigned_, materials_, options_.signals, part(begin, end));
    result_.errorsAfter = fullErrors(assigned_, materials_, options_.signals, part(end, 1));
  }

  const TrainingMaterials& materials_;
  const TrainingOptions& options_;
  const TaskControl& control_;
  const std::function<void(const TrainingState&)>& checkpoint_;
  TrainingResult result_;
  std::vector<CompactSignal<double>> signals_;
  std::vector<std::vector<int>> memberships_;
  std::vector<AssignedEnsemble> assigned_;
};

}  // namespace

TrainingResult train(const TrainingMaterials& materials, const TrainingOptions& options, const TaskControl& control,
                     const TrainingState* resume, const std::function<void(const TrainingState&)>& checkpoint) {
  if (materials.names.empty()) throw Error("found no materials to learn dictionaries from");
  return Training(materials, options, control, checkpoint).run(resume);
}

}  // namespace gonio::dictionary
