// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/study/study_record.h"

namespace gonio::study {

/// One representation at one budget over several materials.
struct StudySummary {
  StudyRecord median;             ///< medians over the materials, without NaN
  std::size_t materials = 0;      ///< number of materials with this representation
  double minSnr = 0, maxSnr = 0;  ///< minimum and maximum over the materials, dB; NaN if all are NaN
  std::size_t worst = 0;          ///< the first material with the minimum SNR
};

/// Summarises records of several materials, ordered by family and, within a family, as they first appear. `worst` is an
/// index into `materials`.
std::vector<StudySummary> summarise(std::span<const std::vector<StudyRecord>> materials);

}  // namespace gonio::study
