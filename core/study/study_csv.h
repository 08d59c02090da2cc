// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/plots/csv_table.h"
#include "core/study/machine.h"
#include "core/study/study_record.h"

namespace gonio::study {

/// A line a record: family, id, label, budget, bytes, times, rendered SNR, every metric. The comments say what of:
/// `title`, the scene and size of the pictures, machine, build, date. An SNR without end is "inf", an undefined one an
/// empty field.
plots::CsvTable studyCsv(const std::string& title, std::span<const StudyRecord> records, const MachineFacts& machine,
                         const std::string& pictures);

/// "sphere-studio, 128 x 128, 32 samples": of the pictures of a study.
std::string picturesText(int width, int height, int samples);

}  // namespace gonio::study
