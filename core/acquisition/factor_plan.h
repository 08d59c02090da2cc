// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/acquisition/measured_values.h"
#include "core/acquisition/sampling_plan.h"
#include "core/math/types.h"

namespace gonio::acquisition {

// The two coordinates of a factor measurement: an angle, and the distance of the light from the mirror direction of
// the viewer. One curve ("along") is measured in the mirror direction over the angle, the other ("across") at a fixed
// angle over the distance. theta_R is the polar angle of the mirror direction, equal to that of the viewer; |Dp| is
// defined in core/coordinates/projected_deviation.h.

enum class FactorAxes {
  projectedDeviation,  ///< theta_R, |Dp| (Tongbuasirilai et al. 2017)
  /// theta_d, |Dp|, which do not change when light and viewer are exchanged. Not in the paper. The readings are those
  /// of projectedDeviation: in the mirror direction theta_d is theta_R.
  symmetricDeviation,
  halfDifference,  ///< theta_d, theta_h
  halfOut,         ///< theta_o, theta_h
  /// theta_d, and a distance between |Dp| and theta_h that the readings choose: the material is fitted to all readings
  /// together (reading_surface.h). Not in the paper. The readings are those of projectedDeviation, but fewer on each
  /// curve, and curves across at further angles. FactorMeasurement has the curves of symmetricDeviation.
  adaptive
};
/// Names in JSON, in files and on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 5> factorAxesNames{"projected-deviation", "symmetric-deviation",
                                                                 "half-difference", "half-out", "adaptive"};
/// @throws Error that lists the names.
FactorAxes factorAxesNamed(std::string_view name);

struct FactorCoordinates {
  double angle = 0;     ///< theta_R, theta_d or theta_o, rad, [0, pi/2]
  double distance = 0;  ///< |Dp|, [0, 2), or theta_h, rad, [0, pi/2]; 0 in the mirror direction
};
/// The coordinates of any two directions above the horizon. O(1).
FactorCoordinates toFactorCoordinates(FactorAxes axes, const DirectionPair& pair);

/// Whether the coordinates do not change when light and viewer are exchanged.
inline bool areReciprocal(FactorAxes axes) {
  return axes == FactorAxes::symmetricDeviation || axes == FactorAxes::halfDifference || axes == FactorAxes::adaptive;
}
/// Whether the distance is |Dp|, otherwise theta_h.
inline bool isDeviation(FactorAxes axes) {
  return axes == FactorAxes::projectedDeviation || axes == FactorAxes::symmetricDeviation ||
         axes == FactorAxes::adaptive;
}
/// The axes whose `across` curve has one angle: theta_d of a reading beside the mirror direction is not the fixed
/// angle, theta_R is.
inline FactorAxes readAxes(FactorAxes axes) { return isDeviation(axes) ? FactorAxes::projectedDeviation : axes; }

/// The pair of directions in the plane of incidence with these coordinates; the light is between the mirror direction
/// and the viewer, or beyond the viewer. The coordinates are those of readAxes(). None if no light above the horizon
/// exists. O(1).
std::optional<DirectionPair> fromFactorCoordinates(FactorAxes axes, const FactorCoordinates& place);

// The readings of a factor measurement. A goniometer with two arms in the plane of incidence measures two curves:
// "along", in the mirror direction at increasing angles; and "across", at one fixed angle and at increasing distances
// from the mirror direction (Tongbuasirilai, Unger and Kurt 2017, "Efficient BRDF Sampling Using Projected Deviation
// Vector Parameterization"; Tongbuasirilai 2023, "Data-Driven Approaches for Sparse Reflectance Modeling and
// Acquisition", section 5.2.1).

/// The two curves of a factor measurement, and readings beside them.
enum class FactorCurve {
  along,   ///< in the mirror direction, over the angle
  across,  ///< at the fixed angle, over the distance from the mirror direction
  further  ///< at any directions; used by FactorAxes::adaptive alone
};
/// Names in files, in the order of the enumeration.
inline constexpr std::array<std::string_view, 3> factorCurveNames{"along", "across", "further"};

struct FactorPlanOptions {
  FactorAxes axes = FactorAxes::projectedDeviation;
  double fixedAngle = radians(60);  ///< of the `across` curve: theta_R, theta_d or theta_o, rad
  /// Number of `along` readings, evenly spaced in the angle, from 0 to maxPolarAngle; [2, 2000]. For adaptive axes only
  /// the sum angles + distances counts.
  int angles = 90;
  int distances = 90;  ///< number of `across` readings, evenly spaced in the square root of the distance; [2, 2000]
  double maxPolarAngle = radians(89);  ///< maximum polar angle of both arms, rad, (0, pi/2)
  double minSeparation = radians(2);   ///< minimum angle between the arms, rad; below it one arm occludes the other
};

struct FactorPlan {
  FactorAxes axes = FactorAxes::projectedDeviation;
  SamplingPlan plan;                ///< `along` by the angle, `across` by the distance, then `further`
  std::vector<FactorCurve> curves;  ///< one per sample
  int blocked = 0;  ///< number of readings that were left out: a direction is below the horizon or beyond
                    ///< maxPolarAngle, or one arm occludes the other
};

/// The pairs of directions to measure. The `across` curve starts with the mirror direction at the fixed angle. For
/// adaptive axes, two ninths of the readings are on each curve; the others are `further` readings with the viewer at up
/// to five other angles (fewer below 100 readings), with the light on both sides of the mirror direction.
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

// The readings of a factor measurement as CSV (csv_text.h), directions and values in one file: the comment "method:
// factors, AXES", then the columns
//   index, curve, theta_i, phi_i, theta_o, phi_o, order, r, g, b
// and optionally noise_r, noise_g, noise_b. `curve` is "along" (the mirror direction), "across" (at the fixed
// angle) or "further" (any directions); angles are in degrees (sampling_plan.h), values as in measured_values.h, also
// as spectra.

struct FactorReadings {
  FactorPlan plan;
  MeasuredValues values;  ///< one per sample of the plan
};

/// Angles have six decimals, values are written without loss. @param values may be empty: the file then lists the
/// directions to measure and has no columns r, g, b.
std::string factorReadingsCsv(const FactorPlan& plan, const MeasuredValues& values = {});
/// Writes a file, atomically. @throws Error that names the file, or a sample whose value cannot be read again
/// (checkMeasured()).
void writeFactorReadings(const FactorPlan& plan, const MeasuredValues& values, const std::filesystem::path& path);

/// Reads the directions and the values. Rows and columns may have any order. @param axes axes of the curves. They may
/// differ from those in the comment of the file, because the same readings can serve several axes; factorMeasurement()
/// checks that those of the two curves lie on them. @throws Error that names the file and the line: a missing column,
/// an angle or value out of range, or a curve other than "along", "across" and "further".
FactorReadings readFactorReadings(const std::filesystem::path& path, FactorAxes axes);
/// The same for text; errors name no file.
FactorReadings parseFactorReadings(std::string_view text, FactorAxes axes);

}  // namespace gonio::acquisition
