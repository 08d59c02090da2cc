// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <string>

#include "core/acquisition/factor_measurement.h"
#include "core/factorization/pdv_factors.h"

/// The material that the two curves of a factor measurement predict, and how far the readings support it.
namespace gonio::acquisition {

/// Upper bound of the predicted values.
enum class FactorBound {
  /// The prediction is at most the larger of two interpolated readings (z_i1 at the same angle, z_mj at the same
  /// distance), and at most the prediction for the exchanged pair. Reason: a real material is reciprocal. Each `across`
  /// reading, taken with the viewer at the fixed angle, is therefore also the value for the exchanged pair: light at
  /// the fixed angle, viewer at another angle. Where the `along` curve increases toward the horizon, a product of
  /// curves over theta_R or theta_o contradicts these values, because the product multiplies the diffuse term by the
  /// increase too.
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
/// with areReciprocal().
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
