// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/acquisition/measured_values.h"

/// Measured values of a sampling plan as CSV (csv_text.h): the columns index, r, g, b (linear sRGB, 1/sr, without the
/// cosine), and optionally standard deviations: noise_r, noise_g, noise_b, or one column noise for all three. Rows may
/// have any order; other columns are ignored.
///
/// Without r, g and b, three or more columns with wavelengths as names ("550", "550nm" or "550 nm") are a spectrum,
/// which is converted to linear sRGB (spectrumWeights()); negative channels become 0; `noise` applies to each
/// wavelength.
namespace gonio::acquisition {

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
