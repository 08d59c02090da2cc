// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/study/study_record.h"

namespace gonio::study {

/// One representation at one budget over several materials.
struct StudySummary {
  StudyRecord median;  ///< every number is the median over the materials; those that are not numbers are left out
  std::size_t materials = 0;        ///< that were measured with it
  double leastSnr = 0, maxSnr = 0;  ///< dB, over the materials; NaN where none has a number
  std::size_t worst = 0;            ///< the first material of the least SNR
};

/// In the order in which the representations first appear. `worst` is an index into `materials`.
std::vector<StudySummary> summarise(std::span<const std::vector<StudyRecord>> materials);

}  // namespace gonio::study
