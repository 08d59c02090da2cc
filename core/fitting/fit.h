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
  /// The metric to minimise; must be minimisable (metrics::MetricRecord).
  metrics::BrdfMetric metric = metrics::BrdfMetric::log;
  /// g of BrdfMetric::gamma (exponent 1/g), minGamma to maxGamma; other metrics do not use it.
  double gamma = metrics::defaultGamma;
  /// Cells with a larger polar angle (rad) are excluded as grazing.
  double maxPolarAngle = metrics::defaultMaxPolarAngle;
};

struct FitResult {
  const models::Model* model = nullptr;
  models::ParameterValues parameters;  ///< always inside the hard ranges
  std::vector<double> errors;          ///< against the measurement, in the order of metrics::allBrdfMetrics()
  double seconds = 0;
  std::size_t usedCells = 0;     ///< number of cells in the comparison
  std::size_t invalidCells = 0;  ///< excluded: below the horizon or not measured
  std::size_t grazingCells = 0;  ///< excluded: beyond maxPolarAngle
  bool cancelled = false;        ///< whether the fit was stopped early; the parameters are then the best so far
  std::vector<std::string> warnings = {};  ///< messages for the user about a degenerate measurement; usually empty
};

/// Fits a model to a BRDF. Isotropic BRDFs are fitted as a table: parameters along two axes get the same value and the
/// rotation is 0. Anisotropic BRDFs are fitted to cells over all azimuths of both directions (FitData). The fit then
/// has separate parameters for the two axes and the direction of the grain; it starts from several directions of the
/// grain, evenly spread over 180 degrees. It returns parameters in canonical form: x, the axis along which the
/// highlight is narrower, is along the grain, and the rotation is in [-pi/2, pi/2). Variable projection: the linear
/// parameters are solved inside each trial, within their bounds and in the metric's own domain; the others by a bounded
/// least-squares solver from several starts, first on a stratified subset of the cells, then refined on a larger one.
/// Parameters are shared or per channel according to the model's specs. Deterministic. A stop request returns the best
/// result so far (`cancelled`); fit() never throws Cancelled. Under 3 s per model for a table, about twice that for
/// anisotropic data.
/// @param choices values of all parameters. Only those of the choices are used, i.e. of parameters that select one of
/// several named formulas (ParameterSpec::choices); choices are not fitted. Empty: the defaults, except that optional
/// lobes of layered models are only enabled if each lowers the error by at least 5 %.
FitResult fit(const Brdf& base, const models::Model& model, const FitOptions& options = {},
              const TaskControl& control = {}, const models::ParameterValues& choices = {});

/// What a material is fitted to, and what the errors of its fits are measured against.
struct FitBase {
  std::shared_ptr<const Brdf> fitted;       ///< the native form if it is anisotropic, else the table
  std::shared_ptr<const Brdf> measurement;  ///< the native form
};
inline FitBase fitBase(const std::shared_ptr<const Brdf>& own, const std::shared_ptr<const TabulatedBrdf>& table) {
  if (own->isIsotropic()) return {table, own};
  return {own, own};
}
/// The same with the errors against the measurement.
FitResult fit(const FitBase& base, const models::Model& model, const FitOptions& options = {},
              const TaskControl& control = {}, const models::ParameterValues& choices = {});

}  // namespace gonio::fitting
