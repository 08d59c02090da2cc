// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/acquisition/factor_axes.h"
#include "core/acquisition/sampling_plan.h"

/// The readings of a factor measurement. A goniometer with two arms in the plane of incidence measures two curves:
/// "along", in the mirror direction at increasing angles; and "across", at one fixed angle and at increasing distances
/// from the mirror direction (Tongbuasirilai, Unger and Kurt 2017, "Efficient BRDF Sampling Using Projected Deviation
/// Vector Parameterization"; Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and
/// Acquisition", section 5.2.1).
namespace gonio::acquisition {

/// The two curves of a factor measurement.
enum class FactorCurve {
  along,  ///< in the mirror direction, over the angle
  across  ///< at the fixed angle, over the distance from the mirror direction
};
/// Names in files, in the order of the enumeration.
inline constexpr std::array<std::string_view, 2> factorCurveNames{"along", "across"};

struct FactorPlanOptions {
  FactorAxes axes = FactorAxes::projectedDeviation;
  double fixedAngle = radians(60);  ///< of the `across` curve: theta_R, theta_d or theta_o, rad
  int angles = 90;     ///< number of `along` readings, evenly spaced in the angle, from 0 to maxPolarAngle; [2, 2000]
  int distances = 90;  ///< number of `across` readings, evenly spaced in the square root of the distance; [2, 2000]
  double maxPolarAngle = radians(89);  ///< maximum polar angle of both arms, rad, (0, pi/2)
  double minSeparation = radians(2);   ///< minimum angle between the arms, rad; below it one arm occludes the other
};

struct FactorPlan {
  FactorAxes axes = FactorAxes::projectedDeviation;
  SamplingPlan plan;                ///< first the `along` curve, by the angle; then the `across` curve, by the distance
  std::vector<FactorCurve> curves;  ///< one per sample
  int blocked = 0;  ///< number of readings that were left out: a direction is below the horizon or beyond
                    ///< maxPolarAngle, or one arm occludes the other
};

/// The pairs of directions to measure. The `across` curve starts with the mirror direction at the fixed angle.
/// O(angles + distances).
/// @throws Error if an option is out of range, or the rig reaches no reading of a curve.
FactorPlan planFactors(const FactorPlanOptions& options = {});

/// The text of SamplingPlan::method for a factor measurement, e.g. "factors, half-out"; and its inverse, which is empty
/// for other texts.
std::string factorMethod(FactorAxes axes);
std::optional<FactorAxes> axesOfFactorMethod(std::string_view method);

/// The value of FactorPlanOptions::angles for a plan with these `along` angles. For successive multiples of one spacing
/// it also counts the multiples below the first angle, which planFactors() leaves out because one arm occludes the
/// other; for other angles it is their number. @param angles increasing, rad.
int plannedReadings(std::span<const double> angles);

}  // namespace gonio::acquisition
