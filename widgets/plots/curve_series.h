// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/plots/csv_table.h"
#include "core/plots/section.h"
#include "widgets/plots/plot_series.h"

/// What all plots of curves need.
namespace gonio::widgets {

/// Angles in degrees in the first column, then one column a curve of the chosen channel.
std::vector<plots::CsvColumn> curveColumns(const PlotSeriesList<plots::Curve>& series, const std::string& angle,
                                           plots::Channel channel, const std::string& unit);
/// All values of some curves that a scale is to show.
std::vector<double> shownValues(const PlotSeriesList<plots::Curve>& series, plots::Channel channel);
/// "measured 0.2 1/sr", a line a curve.
QString curveReadout(const PlotSeriesList<plots::Curve>& series, double angle, plots::Channel channel,
                     const QString& unit);

}  // namespace gonio::widgets
