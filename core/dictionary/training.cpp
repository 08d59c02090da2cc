// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/training.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <numeric>
#include <random>

#include "core/dictionary/alternatives/full_sweep.h"
#include "core/dictionary/largest_projections.h"
#include "core/dictionary/mode_products.h"
#include "core/math/decompositions.h"
#include "core/math/parallel.h"

namespace gonio::dictionary {

namespace {

/// Signals of one sum that a thread adds up alone; the sums of such parts are added in order.
constexpr std::size_t partSize = 8;

/// Sum over members of `add(member, sum)`, in parts of fixed size: the same bits for any number of threads.
template <typename Add>
Eigen::MatrixXd sumOver(std::span<const int> members, int size, const Add& add, const TaskControl& control) {
  const std::size_t parts = (members.size() + partSize - 1) / partSize;
  std::vector<Eigen::MatrixXd> sums(parts, Eigen::MatrixXd::Zero(size, size));
  parallelForBlocks(members.size(), partSize,
                    [&](std::size_t begin, std::size_t end) {
                      for (std::size_t m = begin; m < end; ++m) add(members[m], sums[begin / partSize]);
                    },
                    {.stop = control.stop});
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  for (const Eigen::MatrixXd& part : sums) sum += part;
  return sum;
}

}  // namespace

namespace {

double energyOf(const EnsembleLearner::Signal& signal) {
  double sum = 0;
  for (const CompactSignal<double>& part : signal) sum += part.energy;
  return sum;
}

}  // namespace

EnsembleLearner::EnsembleLearner(std::span<const Signal> signals, const Sizes& sizes, int dictionaries, int sparsity)
    : signals_(signals),
      sizes_(sizes),
      sparsity_(sparsity),
      dictionaries_(std::size_t(dictionaries)),
      memberships_(signals.size()),
      errors_(signals.size()),
      coefficients_(signals.size()) {
  assert(dictionaries >= 1 && sparsity >= 0);
  for (const Signal& signal : signals) totalEnergy_ += energyOf(signal);
}

void EnsembleLearner::start(std::vector<ModeMatrices<double>> dictionaries) {
  assert(dictionaries.size() == dictionaries_.size());
  dictionaries_ = std::move(dictionaries);
}

void EnsembleLearner::start(std::uint64_t seed, const TaskControl& control) {
  std::vector<int> order(signals_.size());
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(seed);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[std::size_t(random() % i)]);
  const std::size_t k = dictionaries_.size();
  for (std::size_t d = 0; d < k; ++d) {
    const std::size_t begin = d * order.size() / k, end = (d + 1) * order.size() / k;
    dictionaries_[d] = leadingVectors(std::span(order).subspan(begin, end - begin), control);
  }
}

ModeMatrices<double> EnsembleLearner::leadingVectors(std::span<const int> members, const TaskControl& control) const {
  ModeMatrices<double> result;
  for (int mode = 0; mode < 3; ++mode) {
    const Eigen::MatrixXd gram = sumOver(
        members, sizes_[std::size_t(mode)],
        [&](int i, Eigen::MatrixXd& sum) {
          for (const CompactSignal<double>& part : signals_[std::size_t(i)]) {
            const int rank = part.ranks[std::size_t(mode)];
            Eigen::MatrixXd inner = Eigen::MatrixXd::Zero(rank, rank);
            addGram(part.block.data(), part.ranks, mode, inner);
            const Eigen::MatrixXd basis = part.bases[std::size_t(mode)];
            sum += basis * inner * basis.transpose();
          }
        },
        control);
    result[std::size_t(mode)] = eigenBasis(gram).vectors;
  }
  return result;
}

void EnsembleLearner::select(const Signal& signal, const ModeMatrices<double>& dictionary, Workspace<double>& workspace,
                             Coefficients& selected) const {
  selected.resize(signal.size());
  for (std::size_t part = 0; part < signal.size(); ++part)
    signal[part].selectLargest(dictionary, std::size_t(sparsity_), workspace, selected[part]);
  keepLargest(selected, std::size_t(sparsity_));
}

double EnsembleLearner::assign(const TaskControl& control) {
  std::vector<Coefficients> coefficients(signals_.size());
  std::vector<int> memberships(signals_.size());
  std::vector<double> errors(signals_.size());
  parallelForBlocks(
      signals_.size(), 4,
      [&](std::size_t begin, std::size_t end) {
        Workspace<double> workspace;
        Coefficients kept;
        for (std::size_t i = begin; i < end; ++i) {
          double most = -1;
          for (std::size_t d = 0; d < dictionaries_.size(); ++d) {
            select(signals_[i], dictionaries_[d], workspace, kept);
            double captured = 0;
            for (const std::vector<Coefficient<double>>& part : kept) captured += energy<double>(part);
            if (!(captured > most)) continue;
            most = captured;
            memberships[i] = int(d);
            coefficients[i].swap(kept);
          }
          errors[i] = std::max(energyOf(signals_[i]) - most, 0.0);
        }
      },
      control);
  coefficients_.swap(coefficients);
  memberships_.swap(memberships);
  errors_.swap(errors);
  return totalEnergy_ > 0 ? std::accumulate(errors_.begin(), errors_.end(), 0.0) / totalEnergy_ : 0;
}

/// Each signal's largest coefficients over its own dictionary.
void EnsembleLearner::selectCoefficients(const std::vector<ModeMatrices<double>>& dictionaries,
                                         const TaskControl& control) {
  parallelForBlocks(
      signals_.size(), 4,
      [&](std::size_t begin, std::size_t end) {
        Workspace<double> workspace;
        for (std::size_t i = begin; i < end; ++i)
          select(signals_[i], dictionaries[std::size_t(memberships_[i])], workspace, coefficients_[i]);
      },
      control);
}

double EnsembleLearner::iterate(const TaskControl& control, int passes) {
  const double error = assign(control);
  const TaskControl stop{.stop = control.stop};
  std::vector<ModeMatrices<double>> renewed = dictionaries_;
  const std::vector<std::vector<int>> groups = members();
  for (int pass = 0; pass < passes; ++pass) {
    if (pass > 0) selectCoefficients(renewed, stop);
    for (int mode = 0; mode < 3; ++mode) renew(mode, groups, renewed, stop);
  }
  reseedEmpty(groups, renewed, stop);
  dictionaries_.swap(renewed);
  return error;
}

std::vector<std::vector<int>> EnsembleLearner::members() const {
  std::vector<std::vector<int>> groups(dictionaries_.size());
  for (std::size_t i = 0; i < memberships_.size(); ++i) groups[std::size_t(memberships_[i])].push_back(int(i));
  return groups;
}

void EnsembleLearner::renew(int mode, const std::vector<std::vector<int>>& members,
                            std::vector<ModeMatrices<double>>& dictionaries, const TaskControl& control) const {
  std::vector<Eigen::MatrixXd> correlations(dictionaries.size());
  for (std::size_t d = 0; d < dictionaries.size(); ++d) {
    correlations[d] = sumOver(
        members[d], sizes_[std::size_t(mode)],
        [&](int i, Eigen::MatrixXd& sum) {
          thread_local Workspace<double> workspace;
          const Signal& signal = signals_[std::size_t(i)];
          for (std::size_t p = 0; p < signal.size(); ++p) {
            const CompactSignal<double>& part = signal[p];
            Eigen::MatrixXd inner = Eigen::MatrixXd::Zero(part.ranks[std::size_t(mode)], sizes_[std::size_t(mode)]);
            addCorrelation(part.block.data(), part.ranks, part.inBases(dictionaries[d]), mode,
                           coefficients_[std::size_t(i)][p], workspace, inner);
            sum.noalias() += part.bases[std::size_t(mode)] * inner;
          }
        },
        control);
  }
  parallelForBlocks(dictionaries.size(), 1, [&](std::size_t begin, std::size_t) {
    if (!members[begin].empty()) dictionaries[begin][std::size_t(mode)] = orthogonalProcrustes(correlations[begin]);
  });
}

/// A dictionary without a member starts again from the signal that the others serve worst.
void EnsembleLearner::reseedEmpty(const std::vector<std::vector<int>>& members,
                                  std::vector<ModeMatrices<double>>& dictionaries, const TaskControl& control) const {
  std::vector<int> order(errors_.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return errors_[std::size_t(a)] > errors_[std::size_t(b)]; });
  std::size_t next = 0;
  for (std::size_t d = 0; d < dictionaries.size() && next < order.size(); ++d)
    if (members[d].empty()) dictionaries[d] = leadingVectors(std::span(order).subspan(next++, 1), control);
}

namespace {

/// Fraction of its energy that a signal may omit in the rounds: little beside their errors of 1e-3 or more.
constexpr double signalLoss = 1e-5;
// Fractions of the progress: the passes that find the subspace, the rounds in it, the last sweep.
constexpr double subspaceFraction = 0.15, roundsFraction = 0.6;

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
          findSharedSubspace(materials_, options_.signals, options_.subspaceLoss, part(0, subspaceFraction / 2));
    signals_.resize(materials_.names.size() * options_.signals.signalsPerMaterial());
    forEachProjection(
        state.subspace, materials_, options_.signals,
        [&](std::size_t signal, std::span<const double> blocks) {
          const std::size_t size = count(state.subspace.ranks);
          for (std::size_t begin = 0; begin < blocks.size(); begin += size)
            signals_[signal].push_back(compactSignal(&blocks[begin], state.subspace.ranks, signalLoss));
        },
        part(subspaceFraction / 2, subspaceFraction));
  }

  bool settled(const std::vector<double>& errors) const {
    if (int(errors.size()) >= options_.iterations) return true;
    if (errors.size() < 2) return false;
    const double last = errors.back(), former = errors[errors.size() - 2];
    return former - last <= options_.tolerance * former;
  }

  void learn(std::size_t e) {
    TrainingState& state = result_.state;
    EnsembleLearner learner(signals_, state.subspace.ranks, options_.dictionaries, options_.sparsities[e]);
    const double each = roundsFraction / double(options_.sparsities.size());
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
      control_.report(subspaceFraction + each * (double(e) + std::min(1.0, rounds)));
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
    const double begin = subspaceFraction + roundsFraction, end = 0.95;
    result_.errorsBefore = sweepFullSpace(assigned_, materials_, options_.signals, part(begin, end));
    result_.errorsAfter = fullErrors(assigned_, materials_, options_.signals, part(end, 1));
  }

  const TrainingMaterials& materials_;
  const TrainingOptions& options_;
  const TaskControl& control_;
  const std::function<void(const TrainingState&)>& checkpoint_;
  TrainingResult result_;
  std::vector<EnsembleLearner::Signal> signals_;
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
