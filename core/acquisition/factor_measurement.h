// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <vector>

#include "core/acquisition/factor_plan.h"
#include "core/acquisition/measured_values.h"

namespace gonio::acquisition {

/// The two curves of a factor measurement in z = ln(1 + rho), per channel, at the coordinates that were read
/// (Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition", eq. 5.1 to 5.5):
/// z_ij is z at angle i and distance j; j = 1 is the mirror direction, i = m the fixed angle.
struct FactorMeasurement {
  FactorAxes axes = FactorAxes::projectedDeviation;
  double fixedAngle = 0;                     ///< of the `across` curve, rad
  std::vector<double> angles, distances;     ///< strictly increasing
  std::array<std::vector<double>, 3> along;  ///< z_i1: in the mirror direction, for each angle
  /// z_mj / z_m1: at the fixed angle, for each distance. For symmetricDeviation this is multiplied by z(fixed angle) /
  /// z(theta_d) of the `along` curve.
  std::array<std::vector<double>, 3> across;
  std::array<std::vector<double>, 3> acrossRead;  ///< z_mj
  /// Per channel: whether the reading in the mirror direction at the fixed angle is black (z_m1 <= 1e-12). Then `along`
  /// is 1, `across` is z_mj, and the prediction is z_mj at every angle.
  std::array<bool, 3> unscaled{};
  std::array<double, 3> highest{};  ///< the largest z that was read
};

/// The curves of measured values. @param plan from planFactors() or from a file; the samples may be in any order.
/// @param values one per sample.
/// @throws Error that names the sample: a curve without readings, an `along` reading outside the mirror direction, an
/// `across` reading at another angle than the first (tolerance 0.1 degrees), or two readings of a curve at the same
/// coordinates.
FactorMeasurement factorMeasurement(const FactorPlan& plan, const MeasuredValues& values);

/// Simulates the readings of a material and forms their curves.
FactorMeasurement measureFactors(const Brdf& material, const FactorPlanOptions& options = {},
                                 const MeasurementNoise& noise = {});

}  // namespace gonio::acquisition
