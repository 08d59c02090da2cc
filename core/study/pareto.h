// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/study/study_record.h"

namespace gonio::study {

/// Cost and error of a candidate; smaller is better for both.
struct CostAndError {
  double cost = 0;
  double error = 0;  ///< for a quality in dB its negative; -infinity: no error
};

/// The Pareto front: candidates for which no other has at most the same cost and error and is better in one of them.
/// Equal ones are all included; NaN in either is excluded. @return indices by increasing cost, in their order among
/// equals. O(n log n).
std::vector<std::size_t> paretoFront(std::span<const CostAndError> candidates);

/// Limits for a representation; empty: no limit.
struct Budget {
  std::optional<double> frameMilliseconds;  ///< maximum
  std::optional<double> renderedSnr;        ///< minimum, dB
  std::optional<double> bytes;              ///< maximum
};

/// The record within all limits that has the highest rendered SNR; among equals the one with the shortest frame time,
/// then with the fewest bytes, then the first. A NaN SNR (black material) fails every limit of the SNR and ranks last.
/// Empty if no record meets all limits.
std::optional<std::size_t> bestWithin(std::span<const StudyRecord> records, const Budget& budget);

}  // namespace gonio::study
