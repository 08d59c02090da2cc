// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "app/goniotool/report.h"
#include "core/study/machine.h"
#include "core/study/study_summary.h"

/// What `goniotool study` writes and prints.
namespace gonio::tool {

/// What the records of a file are of: in its header, and for people.
struct StudyTitle {
  std::string material;  ///< of a summary "median of 10 materials"
  std::string pictures;  ///< study::picturesText()
  study::MachineFacts machine;
};

Json machineJson(const study::MachineFacts& machine);
/// One a record, each with the costs over which it stands on the Pareto front of its fellows.
Json recordsJson(std::span<const study::StudyRecord> records);
/// The same of medians, each with the count of materials and the least and largest rendered SNR.
Json summaryJson(std::span<const study::StudySummary> summaries);
/// A table for people.
std::string recordsText(std::span<const study::StudyRecord> records);

/// Writes STEM.json, STEM.csv and STEM.svg. @throws Error naming the file.
void writeStudy(const std::filesystem::path& stem, const StudyTitle& title, std::span<const study::StudyRecord> records,
                const Json& recordsAsJson);

}  // namespace gonio::tool
