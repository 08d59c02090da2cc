// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/metrics/brdf_metric.h"
#include "core/plots/value_scale.h"
#include "core/study/pareto.h"

namespace gonio::study {

/// What the vertical axis of a study is: the error by a metric, or with none the rendered SNR.
using Quality = std::optional<metrics::BrdfMetric>;

/// The error, or the rendered SNR, dB.
double qualityOf(const StudyRecord& record, Quality quality);
/// "rendered SNR [dB]", "error log"; of a cost "evaluation [ns]".
std::string axisTitle(Quality quality);
std::string axisTitle(Cost cost);

/// For paretoFront().
std::vector<Trade> tradesOf(std::span<const StudyRecord> records, Cost cost, Quality quality);

/// An axis with an end for what no scale holds: no cost and no error at all (0 on a logarithmic axis) at its low end,
/// an SNR without end at its high one. Costs and errors are logarithmic, decibels are not.
struct StudyAxis {
  plots::ValueScale scale;
  bool zeroEnd = false, infiniteEnd = false;

  /// Fraction of the axis's length, in [0, 1]; nothing for what is not a number.
  std::optional<double> position(double value) const;

  struct Tick {
    double position;
    std::string text;  ///< "10k" for 10,000; "0" and "∞" at the ends
  };
  std::vector<Tick> ticks() const;
};

/// That shows all values.
StudyAxis costAxis(std::span<const StudyRecord> records, Cost cost);
StudyAxis qualityAxis(std::span<const StudyRecord> records, Quality quality);

/// Three significant digits with the prefix of a thousand: "1.2k", "35M"; "∞".
std::string shortNumber(double value);

}  // namespace gonio::study
