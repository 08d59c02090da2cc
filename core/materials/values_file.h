// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/acquisition/measured_values.h"

/// Measured values of a sampling plan as CSV (csv_text.h): the columns index, r, g, b (linear sRGB, 1/sr, without the
/// cosine), and where standard deviations are known noise_r, noise_g, noise_b, or one column noise for all three.
/// Rows in any order; other columns are passed over.
///
/// Without r, g and b, three or more columns that are named by their wavelength, "550", "550nm" or "550 nm", are a
/// spectrum: it becomes linear sRGB (spectrumWeights()), negative channels 0; `noise` is that of each wavelength.
namespace gonio::materials {

/// With all digits. @param values one a sample of the plan.
std::string valuesCsv(const acquisition::SamplingPlan& plan, const acquisition::MeasuredValues& values);
/// Atomic. @throws Error naming the file.
void writeValues(const acquisition::SamplingPlan& plan, const acquisition::MeasuredValues& values,
                 const std::filesystem::path& path);

/// One value for each sample of the plan, in its order.
/// @throws Error naming the file and, where there is one, the line: a row that is missing, stands twice or has an index
/// that the plan has not; a value that is negative or no number; a column that is missing.
acquisition::MeasuredValues readValues(const std::filesystem::path& path, const acquisition::SamplingPlan& plan);
/// The same of text; an error names no file.
acquisition::MeasuredValues parseValues(std::string_view text, const acquisition::SamplingPlan& plan);

}  // namespace gonio::materials
