// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <vector>

#include "core/study/evaluation_time.h"
#include "core/study/representation.h"

namespace gonio::study {

/// What a representation of a material costs and how far it is off: measured, here and then. A value.
struct StudyRecord {
  Representation representation;
  std::size_t bytes = 0;         ///< of its file; of a table its values and mask in memory; of a fit its numbers as
                                 ///< float32. What all materials share (a dictionary, components) is not counted
  double encodeSeconds = 0;      ///< from the table to the representation; 0 for the table itself
  EvaluationTime evaluation;     ///< ns per pair on one thread, in batches
  double frameMilliseconds = 0;  ///< of a frame of comparisonScene() by the path tracer, all threads: the median
  std::vector<double> errors;    ///< against the table at its nodes, in the order of metrics::allBrdfMetrics()
  double renderedSnr = 0;        ///< dB in comparisonScene(); +infinity for equal pictures, NaN for a black reference
};

/// What the horizontal axis of a study is.
enum class Cost { evaluation, frame, bytes, encoding };
inline constexpr Cost allCosts[] = {Cost::evaluation, Cost::frame, Cost::bytes, Cost::encoding};

double costOf(const StudyRecord& record, Cost cost);
/// For people: "evaluation", "frame", "size", "encoding".
std::string_view costName(Cost cost);
/// "ns", "ms", "B", "s".
std::string_view costUnit(Cost cost);

}  // namespace gonio::study
