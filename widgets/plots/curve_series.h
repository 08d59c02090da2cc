// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/io/csv_table.h"
#include "core/plots/plotted_values.h"
#include "widgets/plots/plot_series.h"

/// Functions for all plots of curves.
namespace gonio::widgets {

/// Angles in degrees in the first column, then one column per curve, of the selected channel.
std::vector<io::CsvColumn> curveColumns(const PlotSeriesList<plots::Curve>& series, const std::string& angle,
                                        plots::Channel channel, const std::string& unit);
/// The values of all curves, for the choice of a scale.
std::vector<double> shownValues(const PlotSeriesList<plots::Curve>& series, plots::Channel channel);
/// E.g. "measured 0.2 1/sr", one line per curve.
QString curveReadout(const PlotSeriesList<plots::Curve>& series, double angle, plots::Channel channel,
                     const QString& unit);

}  // namespace gonio::widgets
