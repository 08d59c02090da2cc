// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/metrics/brdf_metrics.h"
#include "core/models/model.h"
#include "core/support/task_control.h"

namespace gonio::fitting {

struct FitOptions {
  /// What is made small; one that is minimisable (metrics::MetricRecord).
  metrics::BrdfMetric metric = metrics::BrdfMetric::log;
  /// Of BrdfMetric::gamma alone: from smallestGamma to largestGamma.
  double gamma = metrics::defaultGamma;
  /// Cells with a polar angle beyond this (rad) are left out as grazing.
  double maxPolarAngle = metrics::defaultMaxPolarAngle;
};

struct FitResult {
  const models::Model* model = nullptr;
  models::ParameterValues parameters;  ///< always inside the hard ranges
  std::vector<double> errors;          ///< over all cells, in the order of metrics::allBrdfMetrics()
  double seconds = 0;
  std::size_t usedCells = 0;               ///< cells of the material that count
  std::size_t invalidCells = 0;            ///< left out: below the horizon or not measured
  std::size_t grazingCells = 0;            ///< left out: beyond maxPolarAngle
  bool cancelled = false;                  ///< stopped early: the parameters are the best so far
  std::vector<std::string> warnings = {};  ///< sentences for people about a degenerate measurement; usually none
};

/// Fits a model to a table, or to an anisotropic BRDF by cells over all azimuths of both directions (FitData): there
/// parameters along two axes are fitted apart, with the direction of the grain, from starts all round the half-turn. Of
/// isotropic data both axes get the same value and the rotation stays 0. The parameters come in their canonical order:
/// the grain along the narrower axis, x, and a rotation in [-pi/2, pi/2). Variable projection: the linear parameters
/// are solved inside, non-negative, in the metric's own domain; the others by a bounded least-squares solver from
/// several starts, on a stratified part of the cells first, then refined. Deterministic. Shared or per-channel
/// parameters as the model's specs say. A stop request returns the best so far (`cancelled`); it never throws
/// Cancelled. Under 3 s for one model of a table, about twice that of anisotropic data.
/// @param choices values of all parameters, of which those of choices (conventions) are kept; empty: the defaults,
/// except that of lobes which can be switched off (layered) only as many are on as lower the error by 5 % each.
FitResult fit(const Brdf& base, const models::Model& model, const FitOptions& options = {},
              const TaskControl& control = {}, const models::ParameterValues& choices = {});

/// What a material is fitted by: its own form where that is anisotropic, else the table of it.
inline std::shared_ptr<const Brdf> fitBase(const std::shared_ptr<const Brdf>& own,
                                           const std::shared_ptr<const TabulatedBrdf>& table) {
  return own->isIsotropic() ? table : own;
}

}  // namespace gonio::fitting
