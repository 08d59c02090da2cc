// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/metrics/brdf_metric.h"
#include "core/plots/value_scale.h"
#include "core/study/pareto.h"

namespace gonio::study {

/// The accuracy measure on the vertical axis of a study: the error of a metric, or the rendered SNR if empty.
using Quality = std::optional<metrics::BrdfMetric>;

/// The error, or the rendered SNR in dB.
double qualityOf(const StudyRecord& record, Quality quality);
/// Titles of axes, e.g. "rendered SNR [dB]", "error log"; for a cost e.g. "evaluation [ns]".
std::string axisTitle(Quality quality);
std::string axisTitle(Cost cost);

/// Costs and errors for paretoFront().
std::vector<CostAndError> costsAndErrors(std::span<const StudyRecord> records, Cost cost, Quality quality);

/// An axis with additional positions at the ends for values that the scale cannot represent: 0 on a logarithmic axis at
/// the low end, an infinite SNR at the high end. Costs and errors are logarithmic, decibels linear.
struct StudyAxis {
  plots::ValueScale scale;
  bool zeroEnd = false, infiniteEnd = false;

  /// Position as a fraction of the axis, [0, 1]; empty for NaN.
  std::optional<double> position(double value) const;

  struct Tick {
    double position;
    std::string text;  ///< e.g. "10k" for 10,000; "0" and "∞" at the ends
  };
  std::vector<Tick> ticks() const;
};

/// Axes that show all values.
StudyAxis costAxis(std::span<const StudyRecord> records, Cost cost);
StudyAxis qualityAxis(std::span<const StudyRecord> records, Quality quality);

/// Three significant digits with an SI prefix: "1.2k", "35M"; "∞".
std::string shortNumber(double value);
/// The same with a unit, which has the prefix: "44.7 kB", "512 B", "1.28 µs".
std::string shortQuantity(double value, std::string_view unit);

}  // namespace gonio::study
