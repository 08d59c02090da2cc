// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/acquisition/factor_plan.h"
#include "core/acquisition/measured_values.h"
#include "core/factorization/pdv_factors.h"

namespace gonio::acquisition {

/// The two curves of a factor measurement in z = ln(1 + rho), per channel, at the coordinates that were read
/// (Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition", eq. 5.1 to 5.5):
/// z_ij is z at angle i and distance j; j = 1 is the mirror direction, i = m the fixed angle.
struct FactorMeasurement {
  FactorAxes axes = FactorAxes::projectedDeviation;
  double fixedAngle = 0;                     ///< of the `across` curve, rad
  std::vector<double> angles, distances;     ///< strictly increasing
  std::array<std::vector<double>, 3> along;  ///< z_i1: in the mirror direction, for each angle
  /// z_mj / z_m1: at the fixed angle, for each distance. For symmetricDeviation and adaptive axes this is multiplied by
  /// z(fixed angle) / z(theta_d) of the `along` curve.
  std::array<std::vector<double>, 3> across;
  std::array<std::vector<double>, 3> acrossRead;  ///< z_mj
  /// Per channel: whether the reading in the mirror direction at the fixed angle is black (z_m1 <= 1e-12). Then `along`
  /// is 1, `across` is z_mj, and the prediction is z_mj at every angle.
  std::array<bool, 3> unscaled{};
  std::array<double, 3> highest{};  ///< the largest z that was read on the curves
  FactorReadings all;               ///< for adaptive axes: all readings, to which the prediction is fitted
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

// The material that the two curves of a factor measurement predict, and how far the readings support it.

/// Upper bound of the predicted values.
enum class FactorBound {
  /// The prediction is at most the larger of two interpolated readings (z_i1 at the same angle, z_mj at the same
  /// distance), and at most the prediction for the exchanged pair. Reason: a real material is reciprocal. Each `across`
  /// reading, taken with the viewer at the fixed angle, is therefore also the value for the exchanged pair: light at
  /// the fixed angle, viewer at another angle. Where the `along` curve increases toward the horizon, a product of
  /// curves over theta_R or theta_o contradicts these values, because the product multiplies the diffuse term by the
  /// increase too.
  ///
  /// Of adaptive axes, which are reciprocal: the larger of the two interpolated readings.
  readings,
  none  ///< eq. 5.6 as printed
};
/// Names in JSON and on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 2> factorBoundNames{"readings", "none"};
/// @throws Error that lists the names.
FactorBound factorBoundNamed(std::string_view name);

/// rho = exp(z) - 1 with z_ij = z_mj z_i1 / z_m1 (Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance
/// Modeling and Acquisition", eq. 5.6), limited by `bound`. Exact where z is such a product within the bound. The
/// curves are monotone cubic between the readings and constant beyond them. Reciprocal with `readings`, and for axes
/// with areReciprocal(). For adaptive axes: fitReadings() of all readings.
std::shared_ptr<const Brdf> predictFromFactors(const FactorMeasurement& measurement,
                                               FactorBound bound = FactorBound::readings);

/// How far the readings support a prediction. Fractions refer to all pairs of directions, weighted by cos theta_i cos
/// theta_o and the solid angles.
struct FactorSupport {
  double contradicted = 0;  ///< exchanging light and viewer changes the unbounded prediction by more than a factor of 2
  double extrapolated = 0;  ///< outside the readings: the last reading of a curve is used
  double bounded = 0;  ///< the unbounded prediction exceeds both readings of FactorBound::readings more than twofold
  /// Sentences for the user: where and why the prediction is unreliable; empty if nothing speaks against it. An empty
  /// list does not prove that the material is a product of two curves.
  std::vector<std::string> warnings;
};
/// The fractions are those of directions every `stepDegrees` in theta_i, theta_o and phi. About 1 ms at 5 degrees.
/// @throws Error unless the step is a divisor of 90.
FactorSupport supportOf(const FactorMeasurement& measurement, int stepDegrees = 5);

/// The unbounded prediction over theta_R and |Dp| as PDV factors with one term; their upper bound (PdvFactors::highest)
/// is the largest reading of all channels. @throws Error for axes other than FactorAxes::projectedDeviation.
factorization::PdvFactors pdvFactorsOfCurves(const FactorMeasurement& measurement);

}  // namespace gonio::acquisition
