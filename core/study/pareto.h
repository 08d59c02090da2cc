// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/study/study_record.h"

namespace gonio::study {

/// What something costs and what it is worth: a smaller cost and a smaller error are better.
struct Trade {
  double cost = 0;
  double error = 0;  ///< of a quality in decibels its negative; -infinity is no error
};

/// Those that no other beats: none costs at most as much with at most the error and is better in one of both. Equals
/// stand together. What has no number (NaN) in either is left out.
/// @return indices, cheapest first; in their order among equals. O(n log n).
std::vector<std::size_t> paretoFront(std::span<const Trade> trades);

/// Limits that a representation has to keep; those that are absent are none.
struct Budget {
  std::optional<double> frameMilliseconds;  ///< at most
  std::optional<double> renderedSnr;        ///< at least, dB
  std::optional<double> bytes;              ///< at most
};

/// The record that keeps all limits and has the highest rendered SNR; among equals the one with the shorter frame, then
/// with fewer bytes, then the first. A record whose SNR is not a number (a black material) keeps no limit of it and
/// is taken only where nothing else is left. Nothing where no record keeps all limits.
std::optional<std::size_t> bestWithin(std::span<const StudyRecord> records, const Budget& budget);

}  // namespace gonio::study
