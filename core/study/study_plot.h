// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "core/plots/svg_drawing.h"
#include "core/study/study_axis.h"

namespace gonio::study {

/// Style of the points of representations in all plots. The colour is that of the family, and so is the shape, except
/// that each baseline, the separated components, compact PDV factors, and the codes of the families `published` and
/// `alternatives` have shapes of their own. Hollow: the table without interpolation, PDV factors with two curves, codes
/// by basis pursuit, patches, and some baselines.
struct SeriesStyle {
  plots::Marker marker;
  std::string_view colour;
  bool hollow;
  std::string name;  ///< in a legend
};
SeriesStyle styleOf(const Representation& representation);

/// The axes of a plot.
struct StudyAxes {
  Cost cost = Cost::evaluation;
  Quality quality = {};
};
/// Axes for the rendered SNR over each cost.
std::vector<StudyAxes> allCostAxes();

/// An SVG file with panels, two per row, and one legend: a point per record, a thin line that joins the budgets of a
/// representation, and the Pareto front as a thick line with the names of its points. Records with NaN on an axis are
/// omitted.
/// @param notes lines below the plot, e.g. machine, build, date.
std::string studySvg(const std::string& title, std::span<const StudyRecord> records, std::span<const StudyAxes> panels,
                     const std::vector<std::string>& notes);

}  // namespace gonio::study
