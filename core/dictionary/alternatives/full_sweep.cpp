// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/alternatives/full_sweep.h"

#include "core/dictionary/dictionary.h"
#include "core/dictionary/largest_projections.h"
#include "core/dictionary/mode_products.h"
#include "core/math/parallel.h"

namespace gonio::dictionary {

namespace {

using Coefficients = std::vector<std::vector<Coefficient<double>>>;  // of the parts of a signal

/// A pass over the signals.
class Pass {
 public:
  Pass(const std::vector<AssignedEnsemble>& ensembles, const TrainingMaterials& materials, const SignalOptions& options,
       const TaskControl& control)
      : ensembles_(ensembles),
        materials_(materials),
        options_(options),
        control_(control),
        sizes_(modeSizes(materials.grid)) {}

  /// Coefficients of every signal in each ensemble, and the errors.
  std::vector<double> threshold(std::vector<std::vector<Coefficients>>& coefficients) const {
    const std::size_t signals = materials_.names.size() * options_.signalsPerMaterial();
    coefficients.assign(ensembles_.size(), std::vector<Coefficients>(signals));
    std::vector<double> energies(signals);
    forEachSignal(
        materials_, options_,
        [&](std::size_t, std::size_t signal, std::span<const Eigen::ArrayXd> parts) {
          thread_local Workspace<double> workspace;
          for (const Eigen::ArrayXd& values : parts) energies[signal] += values.square().sum();
          for (std::size_t e = 0; e < ensembles_.size(); ++e) {
            const auto sparsity = std::size_t(ensembles_[e].sparsity);
            Coefficients& selected = coefficients[e][signal];
            selected.resize(parts.size());
            for (std::size_t p = 0; p < parts.size(); ++p)
              selectLargestProjections(parts[p].data(), sizes_, matrices(e, signal), sparsity, workspace, selected[p]);
            keepLargest(selected, sparsity);
            for (std::vector<Coefficient<double>>& part : selected) part.shrink_to_fit();
          }
        },
        [](std::size_t) {}, control_);
    return errors(energies, coefficients);
  }

  /// Z of the mode for each dictionary of each ensemble, on a further reading of the materials.
  std::vector<std::vector<Eigen::MatrixXd>> correlations(
      int mode, const std::vector<std::vector<Coefficients>>& coefficients) const {
    const int size = sizes_[std::size_t(mode)];
    const std::size_t perMaterial = options_.signalsPerMaterial();
    std::vector<std::vector<Eigen::MatrixXd>> sums(ensembles_.size()), parts(materials_.names.size());
    for (std::size_t e = 0; e < ensembles_.size(); ++e)
      sums[e].assign(ensembles_[e].dictionaries.size(), Eigen::MatrixXd::Zero(size, size));
    forEachSignal(
        materials_, options_,
        [&](std::size_t material, std::size_t signal, std::span<const Eigen::ArrayXd> signalParts) {
          thread_local Workspace<double> workspace;
          for (std::size_t e = 0; e < ensembles_.size(); ++e) {
            Eigen::MatrixXd& z = parts[material].emplace_back(Eigen::MatrixXd::Zero(size, size));
            for (std::size_t p = 0; p < signalParts.size(); ++p)
              addCorrelation(signalParts[p].data(), sizes_, matrices(e, signal), mode, coefficients[e][signal][p],
                             workspace, z);
          }
        },
        [&](std::size_t material) {
          std::size_t part = 0;
          for (std::size_t signal = material * perMaterial; signal < (material + 1) * perMaterial; ++signal)
            for (std::size_t e = 0; e < ensembles_.size(); ++e)
              sums[e][std::size_t(ensembles_[e].memberships[signal])] += parts[material][part++];
          parts[material].clear();
        },
        control_);
    return sums;
  }

 private:
  const ModeMatrices<double>& matrices(std::size_t ensemble, std::size_t signal) const {
    const AssignedEnsemble& one = ensembles_[ensemble];
    return one.dictionaries[std::size_t(one.memberships[signal])];
  }

  static std::vector<double> errors(const std::vector<double>& energies,
                                    const std::vector<std::vector<Coefficients>>& coefficients) {
    std::vector<double> result;
    for (const std::vector<Coefficients>& ensemble : coefficients) {
      double total = 0, left = 0;
      for (std::size_t s = 0; s < energies.size(); ++s) {
        double captured = 0;
        for (const std::vector<Coefficient<double>>& part : ensemble[s]) captured += energy<double>(part);
        total += energies[s];
        left += std::max(0.0, energies[s] - captured);
      }
      result.push_back(total > 0 ? left / total : 0);
    }
    return result;
  }

  const std::vector<AssignedEnsemble>& ensembles_;
  const TrainingMaterials& materials_;
  const SignalOptions& options_;
  const TaskControl& control_;
  Sizes sizes_;
};

/// The part [begin, end] of a control's progress.
TaskControl part(const TaskControl& control, double begin, double end) {
  return {.stop = control.stop,
          .progress = [&control, begin, end](double fraction) { control.report(begin + (end - begin) * fraction); }};
}

}  // namespace

std::vector<double> fullErrors(const std::vector<AssignedEnsemble>& ensembles, const TrainingMaterials& materials,
                               const SignalOptions& options, const TaskControl& control) {
  std::vector<std::vector<Coefficients>> coefficients;
  return Pass(ensembles, materials, options, control).threshold(coefficients);
}

std::vector<double> sweepFullSpace(std::vector<AssignedEnsemble>& ensembles, const TrainingMaterials& materials,
                                   const SignalOptions& options, const TaskControl& control) {
  std::vector<AssignedEnsemble> renewed = ensembles;
  std::vector<std::vector<Coefficients>> coefficients;
  const std::vector<double> before = Pass(renewed, materials, options, part(control, 0, 0.34)).threshold(coefficients);
  for (int mode = 0; mode < 3; ++mode) {
    const auto correlations = Pass(renewed, materials, options, part(control, 0.34 + 0.22 * mode, 0.56 + 0.22 * mode))
                                  .correlations(mode, coefficients);
    for (std::size_t e = 0; e < renewed.size(); ++e)
      parallelForBlocks(renewed[e].dictionaries.size(), 1, [&](std::size_t d, std::size_t) {
        // A dictionary without a member has nothing to learn from.
        if (correlations[e][d].squaredNorm() > 0)
          renewed[e].dictionaries[d][std::size_t(mode)] = orthogonalProcrustes(correlations[e][d]);
      });
  }
  ensembles.swap(renewed);
  return before;
}

}  // namespace gonio::dictionary
