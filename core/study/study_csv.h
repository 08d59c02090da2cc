// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/plots/csv_table.h"
#include "core/study/machine.h"
#include "core/study/study_record.h"
#include "core/study/study_summary.h"

namespace gonio::study {

/// A line a record: family, id, label, budget, bytes, times, rendered SNR, every metric. The comments say what of:
/// `title`, the scene and size of the pictures, machine, build, date. An SNR without end is "inf", an undefined one an
/// empty field.
plots::CsvTable studyCsv(const std::string& title, std::span<const StudyRecord> records, const MachineFacts& machine,
                         const std::string& pictures);

/// The same of medians over several materials, with the count of materials, the least and the largest rendered SNR, and
/// the material of the least. `materials`: the names of those that were summarised, in their order.
plots::CsvTable summaryCsv(const std::string& title, std::span<const StudySummary> summaries,
                           std::span<const std::string> materials, const MachineFacts& machine,
                           const std::string& pictures);

/// "sphere-studio, 128 x 128, 32 samples": of the pictures of a study.
std::string picturesText(int width, int height, int samples);

}  // namespace gonio::study
