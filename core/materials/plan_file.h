// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/acquisition/sampling_plan.h"

/// A sampling plan as CSV (csv_text.h): comment lines, then the columns
///   index, theta_i, phi_i, theta_o, phi_o, theta_h, theta_d, phi_d, order
/// in degrees; the comments "method: .." and "basis, SHA-256: .." are read. i is the light, o the viewer. theta_h,
/// theta_d and phi_d show people what the other angles state already: readers pass over them, but where all other
/// angles could be radians. `order` is the order of measurement, along a short path of the arms.
namespace gonio::materials {

/// Angles with six decimals: of a node's directions the node is found again.
/// @param comments lines for people, without #.
std::string planCsv(const acquisition::SamplingPlan& plan, const std::vector<std::string>& comments = {});
/// Atomic. @throws Error naming the file.
void writePlan(const acquisition::SamplingPlan& plan, const std::filesystem::path& path,
               const std::vector<std::string>& comments = {});

/// Any order of columns and rows; without a column `order` that path is planned again, other columns are passed over.
/// @throws Error naming the file and the line: a column or an index twice or not at all, an index below 1, an angle
/// that is none in degrees above the horizon, an `order` that is not each number from 1 to that of the rows once, no
/// rows or more than 65,536, or angles that are all radians: small enough, and theta_h and theta_d not those of
/// degrees.
acquisition::SamplingPlan readPlan(const std::filesystem::path& path);
/// The same of text; an error names no file.
acquisition::SamplingPlan parsePlan(std::string_view text);

}  // namespace gonio::materials
