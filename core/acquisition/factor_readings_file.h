// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/acquisition/factor_plan.h"
#include "core/acquisition/measured_values.h"

/// The readings of a factor measurement as CSV (csv_text.h), directions and values in one file: the comment "method:
/// factors, AXES", then the columns
///   index, curve, theta_i, phi_i, theta_o, phi_o, order, r, g, b
/// and optionally noise_r, noise_g, noise_b. `curve` is "along" (the mirror direction) or "across" (at the fixed
/// angle); angles are in degrees (plan_file.h), values as in values_file.h, also as spectra.
namespace gonio::acquisition {

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
/// checks that the readings lie on two curves. @throws Error that names the file and the line: a missing column, an
/// angle or value out of range, or a curve other than "along" and "across".
FactorReadings readFactorReadings(const std::filesystem::path& path, FactorAxes axes);
/// The same for text; errors name no file.
FactorReadings parseFactorReadings(std::string_view text, FactorAxes axes);

}  // namespace gonio::acquisition
