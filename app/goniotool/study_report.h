// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/goniotool/report.h"
#include "core/study/machine.h"
#include "core/study/study_summary.h"

/// Results of `goniotool study` as JSON and as text.
namespace gonio::tool {

/// Empty facts are omitted.
Json machineJson(const study::MachineFacts& machine);
/// One entry per record, with the costs for which it is on the Pareto front of the records.
Json recordsJson(std::span<const study::StudyRecord> records);
/// Inverse of recordsJson(), exact. @throws Json::exception, Error.
std::vector<study::StudyRecord> recordsOf(const Json& json);
/// As recordsJson() for medians, each with the number of materials and the minimum and maximum rendered SNR.
Json summaryJson(std::span<const study::StudySummary> summaries);
/// A table as text.
std::string recordsText(std::span<const study::StudyRecord> records);

}  // namespace gonio::tool
