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

/// What is empty is left out.
Json machineJson(const study::MachineFacts& machine);
/// One a record, each with the costs over which it stands on the Pareto front of its fellows.
Json recordsJson(std::span<const study::StudyRecord> records);
/// Of recordsJson(), with the same bits. @throws Json::exception, Error.
std::vector<study::StudyRecord> recordsOf(const Json& json);
/// The same as recordsJson() of medians, each with the count of materials and the least and largest rendered SNR.
Json summaryJson(std::span<const study::StudySummary> summaries);
/// A table for people.
std::string recordsText(std::span<const study::StudyRecord> records);

}  // namespace gonio::tool
