// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/acquisition/sampling_plan.h"
#include "core/brdf/brdf.h"

namespace gonio::acquisition {

/// The values measured at the samples of a plan, in the order of the plan.
struct MeasuredValues {
  std::vector<Rgb> rgb;    ///< BRDF values: linear RGB, 1/sr, without the cosine, >= 0
  std::vector<Rgb> noise;  ///< standard deviations of `rgb`, 1/sr; empty if unknown
};

/// Errors of a simulated goniometer, all Gaussian.
struct MeasurementNoise {
  double relative = 0;      ///< standard deviation as a fraction of the value, independent per channel
  double absolute = 0;      ///< additional standard deviation, 1/sr: the noise floor
  double misalignment = 0;  ///< standard deviation of each arm's pointing error about each of two axes, rad
  std::uint64_t seed = 1;
};

/// Simulates the measurement of a material at the directions of a plan. Negative readings become 0; a direction that
/// the misalignment moves below the horizon is moved back to it. Fills in MeasuredValues::noise if relative or absolute
/// noise is above 0. The random numbers do not depend on the sizes of the errors: twice the noise gives twice each
/// error.
/// @throws Error if a standard deviation is negative or not finite.
MeasuredValues measure(const Brdf& material, const SamplingPlan& plan, const MeasurementNoise& noise = {});

// Measured values of a sampling plan as CSV (csv_text.h): the columns index, r, g, b (linear sRGB, 1/sr, without the
// cosine), and optionally standard deviations: noise_r, noise_g, noise_b, or one column noise for all three. Rows may
// have any order; other columns are ignored.
//
// Without r, g and b, three or more columns with wavelengths as names ("550", "550nm" or "550 nm") are a spectrum,
// which is converted to linear sRGB (spectrumWeights()); negative channels become 0; `noise` applies to each
// wavelength.

/// Numbers are written without loss. @param values one per sample of the plan.
std::string valuesCsv(const SamplingPlan& plan, const MeasuredValues& values);
/// Writes a file, atomically. @throws Error that names the file, or a sample whose value cannot be read again
/// (checkMeasured()).
void writeValues(const SamplingPlan& plan, const MeasuredValues& values, const std::filesystem::path& path);

/// Reads one value per sample of the plan, in its order. @throws Error that names the file and, if possible, the line:
/// a row that is missing, repeated or not in the plan; a value that is negative or not a number; a missing column.
MeasuredValues readValues(const std::filesystem::path& path, const SamplingPlan& plan);
/// The same for text; errors name no file.
MeasuredValues parseValues(std::string_view text, const SamplingPlan& plan);

}  // namespace gonio::acquisition
