// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <vector>

#include "core/study/evaluation_time.h"
#include "core/study/representation.h"

namespace gonio::study {

/// Measured cost and accuracy of a representation of a material.
struct StudyRecord {
  Representation representation;
  /// Size of its file in bytes. For a table: size of its values and two flags per cell in memory. For a fit: size of
  /// its parameters as float32. Excludes data shared by all materials (dictionary, components).
  std::size_t bytes = 0;
  double encodeSeconds = 0;      ///< time to build the representation from the table; 0 for the table itself, NaN for
                                 ///< RepresentationFamily::publishedNonparametric, which was fitted elsewhere
  EvaluationTime evaluation;     ///< ns per pair on one thread, in batches
  double frameMilliseconds = 0;  ///< median time of a frame of comparisonScene() by the path tracer with all threads
  std::vector<double> errors;    ///< against the measurement, in the order of metrics::allBrdfMetrics()
  double renderedSnr = 0;        ///< in comparisonScene(), dB; +infinity for equal pictures, NaN for a black reference
};

/// The horizontal axis of a study.
enum class Cost { evaluation, frame, bytes, encoding };
inline constexpr Cost allCosts[] = {Cost::evaluation, Cost::frame, Cost::bytes, Cost::encoding};

double costOf(const StudyRecord& record, Cost cost);
/// The name for display: "evaluation", "frame", "size", "encoding".
std::string_view costName(Cost cost);
/// The unit of costOf(): "ns", "ms", "B" or "s".
std::string_view costUnit(Cost cost);

}  // namespace gonio::study
