// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/io/csv_text.h"
#include "core/study/machine.h"
#include "core/study/study_record.h"
#include "core/study/study_summary.h"

namespace gonio::study {

/// A table with one row per record: family, id, label, budget, bytes, times, rendered SNR, every metric. Comments
/// contain `title`, scene and size of the pictures, machine, build and date. An infinite SNR is "inf", an undefined one
/// an empty field.
io::CsvTable studyCsv(const std::string& title, std::span<const StudyRecord> records, const MachineFacts& machine,
                      const std::string& pictures);

/// The same for medians over several materials, with the number of materials, the minimum and maximum rendered SNR, and
/// the material of the minimum. @param materials names of the summarised materials, in order.
io::CsvTable summaryCsv(const std::string& title, std::span<const StudySummary> summaries,
                        std::span<const std::string> materials, const MachineFacts& machine,
                        const std::string& pictures);

/// A description of the pictures of a study, e.g. "sphere-studio, 128 x 128, 32 samples".
std::string picturesText(int width, int height, int samples);

}  // namespace gonio::study
