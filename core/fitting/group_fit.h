// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <mutex>

#include "core/fitting/projected_problem.h"
#include "core/support/task_control.h"

namespace gonio::fitting {

/// Sums the progress of steps that finish in any order, on any thread; never decreases.
class ProgressMeter {
 public:
  explicit ProgressMeter(const TaskControl& control) : control_(control) {}
  void add(double fraction);

 private:
  const TaskControl& control_;
  std::mutex mutex_;
  double done_ = 0;
};

/// Starting points of a search: `base`, and points spread over the soft ranges of the free parameters.
std::vector<models::ParameterValues> startingPoints(const models::Model& model, const models::ParameterValues& base,
                                                    const std::vector<std::size_t>& free);

/// Starting points for anisotropic data around a given one: its parameters along the two axes are separated by several
/// factors, with several directions of the grain, evenly spread over 180 degrees. Empty for a model without a grain.
std::vector<models::ParameterValues> grainStarts(const models::ModelSpec& spec, const models::ParameterValues& about);

/// Fits the parameters of several colour channels together: evaluates starts over the soft ranges, refines the best of
/// them on the cells of `search`, and the best of these on the cells of `polish`. Parameters of the group
/// `shadowing` have a small effect: they are fixed in the first search and fitted in the later ones. Deterministic for
/// any number of threads. Over the cells of `polish` the result is never worse than the best start. A stop request ends
/// the fit early with the best result so far.
/// @param base values of all parameters that are not fitted here.
/// @param fraction of the total progress that this fit reports.
/// @return `base` with the parameters of `channels` (all channels of shared ones) replaced.
models::ParameterValues fitGroup(const models::Model& model, const FitTarget& search, const FitTarget& polish,
                                 const models::ParameterValues& base, const std::vector<int>& channels,
                                 const std::stop_token& stop, ProgressMeter& progress, double fraction);

}  // namespace gonio::fitting
