// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/brdf/brdf.h"
#include "core/coordinates/half_difference_grid.h"
#include "core/metrics/brdf_metric.h"

namespace gonio::metrics {

/// The metrics compare two BRDFs of any form, each evaluated in this form, at the nodes of the reference if it is a
/// table: a table of the same grid is read there, others are interpolated. For other references there is one pair of
/// directions in each cell of a half-difference grid (GridPoints::scattered): that of the test if it is a table, else
/// that of MERL files. So a table that was sampled from the reference is compared between its nodes too. Unless both
/// BRDFs are reciprocal, phi_d covers the whole circle, i.e. both orders of the directions and both sides of the plane
/// of incidence: with the step of the table, else with 180 steps. If one of them is anisotropic, both directions of
/// each pair are rotated about the normal by an angle of its own, 2 pi n / golden ratio for node or cell n. Pairs for
/// which one of the two has no data are left out. The weights are HalfDifferenceGrid::cellMeasure(). A BRDF differs
/// from itself by exactly 0.

/// Default of `maxPolarAngle`, rad: both polar angles are at most this.
inline constexpr double defaultMaxPolarAngle = 85 * 3.14159265358979323846 / 180;

/// The error <|d|^p> or its square root, as MetricRecord defines; 0 for equal values and if no node is used. Negative
/// BRDF values count as 0. Parallel, deterministic.
/// @param gamma g of BrdfMetric::gamma: values are raised to 1/g.
double brdfError(BrdfMetric metric, const Brdf& reference, const Brdf& test,
                 double maxPolarAngle = defaultMaxPolarAngle, double gamma = defaultGamma);
/// All metrics in one pass, in the order of allBrdfMetrics(). About 0.2 s for a MERL table and a fast `test`.
std::vector<double> brdfErrors(const Brdf& reference, const Brdf& test, double maxPolarAngle = defaultMaxPolarAngle,
                               double gamma = defaultGamma);

/// A reference that many BRDFs are compared with: where it is neither a table nor anisotropic, its values are computed
/// once, in single precision (13 bytes for each of 1.5 million cells, twice as many if it is not reciprocal).
class SampledReference {
 public:
  /// `reference` must outlive this object. Parallel; about 0.2 s for an RGL file, nothing for a table.
  explicit SampledReference(const Brdf& reference);
  /// brdfErrors() of the reference and `test`.
  std::vector<double> errors(const Brdf& test, double maxPolarAngle = defaultMaxPolarAngle,
                             double gamma = defaultGamma) const;

 private:
  const Brdf& reference_;
  HalfDifferenceGrid grid_;
  std::vector<glm::vec3> values_;  ///< one a cell; empty if the reference is evaluated each time
  std::vector<std::uint8_t> known_;
};

/// BRDF SNR, dB: 10 log10(sum |r|^2 / sum |r - t|^2) with r, t = rho cos theta_i cos theta_o of reference and test,
/// over all pairs above the horizon, with negative values as they are. Special cases as decibels().
double brdfSignalToNoiseRatio(const Brdf& reference, const Brdf& test);

}  // namespace gonio::metrics
