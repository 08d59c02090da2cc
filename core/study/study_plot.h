// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/metrics/brdf_metric.h"
#include "core/plots/value_scale.h"
#include "core/study/study_record.h"

/// Accuracy over cost: the Pareto front, the best within a budget, axes, and the plot that is exported.
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
/// then with the fewest bytes, then the first. A NaN SNR (black material) fails every limit of the SNR and ranks last;
/// a frame time that was not measured (NaN) fails every limit of the frame time. Empty if no record meets all limits.
std::optional<std::size_t> bestWithin(std::span<const StudyRecord> records, const Budget& budget);

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

/// The axes of a plot.
struct StudyAxes {
  Cost cost = Cost::evaluation;
  Quality quality = {};
};
/// The points of one entry of a legend.
struct StudySeries {
  const RepresentationKind* kind = nullptr;  ///< of the first; all have its legendName() and its look
  std::vector<std::size_t> records;          ///< indices, by increasing budget
  bool isLine = false;                       ///< whether they are budgets of one representation
};

/// Where everything of a plot is, in fractions of the axes from the lower left; for the file and the editor.
struct StudyGeometry {
  StudyAxis costs, qualities;
  std::vector<std::optional<glm::dvec2>> places;  ///< of the records; empty if one of the values is NaN
  std::vector<StudySeries> series;                ///< in the order in which the records name them
  std::vector<std::size_t> front;                 ///< paretoFront()
  std::vector<glm::dvec2> frontSteps;             ///< the corners of its line
};
StudyGeometry studyGeometry(std::span<const StudyRecord> records, const StudyAxes& axes);

/// Axes for the rendered SNR over each cost.
std::vector<StudyAxes> allCostAxes();

/// An SVG file with panels, two per row, and one legend: a point per record, a thin line that joins the budgets of a
/// representation, and the Pareto front as a thick line with the names of its points. Records with NaN on an axis are
/// omitted.
/// @param notes lines below the plot, e.g. machine, build, date.
std::string studySvg(const std::string& title, std::span<const StudyRecord> records, std::span<const StudyAxes> panels,
                     const std::vector<std::string>& notes);

}  // namespace gonio::study
