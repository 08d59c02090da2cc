// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/io/csv_text.h"
#include "core/plots/plotted_values.h"
#include "widgets/charts/plot_style.h"

namespace gonio::widgets {

/// Data (a Curve, a Slice or a LobeSurface) with its name in legends.
template <class Data>
struct PlotSeries {
  SeriesRole role = SeriesRole::measured;
  QString name;
  Data data;
};
template <class Data>
using PlotSeriesList = std::vector<PlotSeries<Data>>;

/// Settings shared by all plots of a view.
struct PlotSettings {
  plots::Channel channel = plots::Channel::luminance;
  bool logarithmic = false;
  plots::CosineFactor cosine = plots::CosineFactor::none;
  double thetaI = radians(45);  ///< angle of incidence, rad

  bool operator==(const PlotSettings&) const = default;
};

/// Maximum angle of incidence of the plots, rad; at 90 degrees the BRDF is undefined.
inline constexpr double maxThetaI = radians(89);

// The texts of plots.

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

// Functions for all plots of curves.

/// Angles in degrees in the first column, then one column per curve, of the selected channel.
std::vector<io::CsvColumn> curveColumns(const PlotSeriesList<plots::Curve>& series, const std::string& angle,
                                        plots::Channel channel, const std::string& unit);
/// The values of all curves, for the choice of a scale.
std::vector<double> shownValues(const PlotSeriesList<plots::Curve>& series, plots::Channel channel);
/// E.g. "measured 0.2 1/sr", one line per curve.
QString curveReadout(const PlotSeriesList<plots::Curve>& series, double angle, plots::Channel channel,
                     const QString& unit);

}  // namespace gonio::widgets
