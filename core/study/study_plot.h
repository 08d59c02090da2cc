// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "core/plots/svg_drawing.h"
#include "core/study/study_axis.h"

namespace gonio::study {

/// How representations are drawn wherever they are points: by the family's colour and shape, hollow for the simpler of
/// two variants (the nearest cell, two curves).
struct SeriesLook {
  plots::Marker marker;
  std::string_view colour;
  bool hollow;
  std::string name;  ///< of the series in a legend
};
SeriesLook lookOf(const Representation& representation);

/// What a plot shows over what.
struct StudyAxes {
  Cost cost = Cost::evaluation;
  Quality quality = {};
};
/// The rendered SNR over each cost.
std::vector<StudyAxes> allCostAxes();

/// Panels side by side, two in a row, as an SVG file: a point a record, budgets of one representation joined by a thin
/// line, the Pareto front as a thick one with the names of its points, one legend for all. Records without a number
/// on an axis are left out.
/// @param notes lines under the plot: machine, build, date.
std::string studySvg(const std::string& title, std::span<const StudyRecord> records, std::span<const StudyAxes> panels,
                     const std::vector<std::string>& notes);

}  // namespace gonio::study
