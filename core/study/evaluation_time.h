// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/brdf/brdf.h"
#include "core/support/task_control.h"

namespace gonio::study {

/// Nanoseconds per pair over several runs of the same batch.
struct EvaluationTime {
  double median = 0, lowerQuartile = 0, upperQuartile = 0;
};

/// How long an evaluation takes on this machine now, in processor time: the calling thread alone evaluates a batch of
/// 16,384 pairs of directions, each even over the solid angle above the horizon, seven times; fewer times, but at least
/// three, where that takes more than half a second. Some ms for most reflectances.
/// @throws Cancelled.
EvaluationTime measureEvaluation(const Brdf& brdf, const TaskControl& control = {});

/// The value below which a fraction of the numbers lies, linear between them; NaN without numbers.
/// @param fraction in [0, 1]: 0.5 is the median.
double quantile(std::vector<double> values, double fraction);

}  // namespace gonio::study
