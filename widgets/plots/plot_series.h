// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <vector>

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

}  // namespace gonio::widgets
