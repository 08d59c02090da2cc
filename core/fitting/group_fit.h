// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <mutex>

#include "core/fitting/projected_problem.h"
#include "core/support/task_control.h"

namespace gonio::fitting {

/// Adds up the fractions of steps that end in any order, on any thread; never falls.
class ProgressMeter {
 public:
  explicit ProgressMeter(const TaskControl& control) : control_(control) {}
  void add(double fraction);

 private:
  const TaskControl& control_;
  std::mutex mutex_;
  double done_ = 0;
};

/// Where a search begins: at `base`, and at points that are spread over the soft ranges of the free parameters.
std::vector<models::ParameterValues> startingPoints(const models::Model& model, const models::ParameterValues& base,
                                                    const std::vector<std::size_t>& free);

/// Starts of anisotropic data about one that was found: its parameters along two axes drawn apart by some factors, the
/// grain in directions all round the half-turn. None for a model without a grain.
std::vector<models::ParameterValues> grainStarts(const models::ModelSpec& spec, const models::ParameterValues& about);

/// Fits the parameters of some colour channels together: starts spread over the soft ranges, the best of them refined
/// on few cells, the best of these on many. Parameters of shadowing join late: they only bend what the others explain.
/// Deterministic for any number of threads. Never worse, over the cells of `polish`, than the best start. A stop
/// request ends it early with the best so far.
/// @param base values of everything that is not fitted here.
/// @param fraction of the progress that this fit may report.
/// @return `base` with the parameters of `channels` (all channels of shared ones) replaced.
models::ParameterValues fitGroup(const models::Model& model, const FitTarget& search, const FitTarget& polish,
                                 const models::ParameterValues& base, const std::vector<int>& channels,
                                 const std::stop_token& stop, ProgressMeter& progress, double fraction);

}  // namespace gonio::fitting
