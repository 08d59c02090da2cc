// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/brdf/brdf.h"

/// Measuring a material by its two factors alone: a goniometer with two arms in the plane of incidence reads one curve
/// along the mirror direction and one across it, and everything else is predicted from them (Tongbuasirilai et al.
/// 2017; dissertation eq. 5.1-5.6).
namespace gonio::acquisition {

/// What the two curves run over.
enum class FactorAxes {
  projectedDeviation,  ///< theta_R, |Dp|
  halfDifference,      ///< theta_d, theta_h
  halfOut,             ///< theta_o, theta_h
  /// theta_d, |Dp|, which stay when light and viewer change places. Read as projectedDeviation: on the curve along the
  /// mirror direction theta_d is theta_R, and the curve across is divided by what the other tells at its theta_d.
  symmetricDeviation
};

struct FactorMeasurementOptions {
  FactorAxes axes = FactorAxes::projectedDeviation;
  double fixedAngle = 1.0;      ///< of the curve across: theta_R, theta_d or theta_o, rad, [0, pi/2)
  int angles = 90;              ///< readings along the mirror direction: even in the angle, to 89 degrees
  int distances = 90;           ///< readings across: even in the square root of |Dp| or theta_h
  double noise = 0;             ///< relative standard deviation of a reading (Gaussian, cut at 0)
  std::uint64_t seed = 1;       ///< of the noise
  double blockedAngle = 0.035;  ///< between the arms, rad: closer than this one stands before the other
};

/// The two curves in z = ln(1 + rho), at the places that could be read.
struct FactorMeasurement {
  FactorAxes axes = FactorAxes::projectedDeviation;
  std::vector<double> angles, distances;
  std::array<std::vector<double>, 3> along;   ///< z_i1: at distance 0, for each angle
  std::array<std::vector<double>, 3> across;  ///< z_mj / z_m1: at the fixed angle, for each distance; with
                                              ///< symmetricDeviation, times z(fixed angle) / z(theta_d) along
  /// Channels whose mirror direction is black at the fixed angle (z_m1 <= 1e-12): their `along` is 1 and `across` is
  /// z_mj itself, the same for all angles.
  std::array<bool, 3> unscaled{};
  int unreadable = 0;  ///< readings that the horizon or an arm stood in the way of: nearest readings stand for them
  double highest = 0;  ///< bound of predictions: the largest z that was read and 2 more
};

/// Reads the two curves of a material. O(angles + distances).
/// @throws Error when an option is out of range or nothing could be read.
FactorMeasurement measureFactors(const Brdf& material, const FactorMeasurementOptions& options = {});

/// The prediction: rho = exp(z) - 1, z_ij = z_mj z_i1 / z_m1; exact where z is such a product. Monotone cubic between
/// readings, held beyond them.
std::shared_ptr<const Brdf> predictFromFactors(const FactorMeasurement& measurement);

}  // namespace gonio::acquisition
