// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/brdf/brdf.h"
#include "core/support/task_control.h"

namespace gonio::study {

/// Nanoseconds per pair, over several runs of the same batch.
struct EvaluationTime {
  double median = 0, lowerQuartile = 0, upperQuartile = 0;
};

/// Measures how much processor time an evaluation takes on this machine at the moment: one thread evaluates a batch of
/// 16,384 pairs of directions, uniform over the hemisphere, seven times, or at least three times if that takes more
/// than half a second. Takes a few ms for most BRDFs. @throws Cancelled.
EvaluationTime measureEvaluation(const Brdf& brdf, const TaskControl& control = {});

/// A quantile, linear between the values; NaN for no values. @param fraction in [0, 1]; 0.5 is the median.
double quantile(std::vector<double> values, double fraction);

}  // namespace gonio::study
