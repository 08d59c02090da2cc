// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <string>

#include "core/plots/plotted_values.h"
#include "widgets/plots/plot_series.h"

/// The texts of plots.
namespace gonio::widgets {

QString channelName(plots::Channel channel);
/// "ρ", "ρ cos θi", "ρ cos θo".
QString cosineName(plots::CosineFactor cosine);
/// Title of an axis of values: "ρ cos θi, luminance [1/sr]".
QString valueTitle(const PlotSettings& settings);
/// "θh", "θd", "θo".
QString axisName(plots::SectionAxis axis);
/// "0.2131 1/sr", or why there is no value.
QString valueText(double value, plots::PointState state = plots::PointState::known);
/// "not measured", "below the horizon".
QString stateText(plots::PointState state);

/// Plain ASCII for CSV files, e.g. "luminance".
std::string channelForCsv(plots::Channel channel);
/// "rho cos theta_i, luminance [1/sr]".
std::string valueForCsv(const PlotSettings& settings);
/// The project's convention for directions and values, on one line.
std::string conventionForCsv();
/// "theta_i = 45 degrees".
std::string angleForCsv(const std::string& name, double radians);

}  // namespace gonio::widgets
