// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/acquisition/sampling_plan.h"

/// A sampling plan as CSV (csv_text.h): comment lines, then the columns
///   index, theta_i, phi_i, theta_o, phi_o, theta_h, theta_d, phi_d, order
/// with angles in degrees; i is the light, o the viewer. The comments "method: .." and "basis, SHA-256: .." are read.
/// theta_h, theta_d and phi_d are redundant, for the user's information; readers only use them to detect angles in
/// radians. `order` is the order of measurement, along a short path of the arms.
namespace gonio::acquisition {

/// Angles have six decimals, enough to find the node of the directions again. @param comments lines of comments,
/// without #.
std::string planCsv(const SamplingPlan& plan, const std::vector<std::string>& comments = {});
/// Writes a file, atomically. @throws Error that names the file.
void writePlan(const SamplingPlan& plan, const std::filesystem::path& path,
               const std::vector<std::string>& comments = {});

/// Reads a plan. Columns and rows may have any order; other columns are ignored; if `order` is missing, the path is
/// planned again. @throws Error that names the file and the line: a missing or repeated column or index, an index below
/// 1, an angle that is not in degrees above the horizon, an `order` that is not a permutation of 1 to the number of
/// rows, no rows or more than 65,536, or angles that appear to be radians (all small, and inconsistent with theta_h and
/// theta_d as degrees).
SamplingPlan readPlan(const std::filesystem::path& path);
/// The same for text; errors name no file.
SamplingPlan parsePlan(std::string_view text);

}  // namespace gonio::acquisition
