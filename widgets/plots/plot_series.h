// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <vector>

#include "core/plots/plotted_values.h"
#include "widgets/charts/plot_style.h"

namespace gonio::widgets {

/// Numbers (a Curve, a Slice or a LobeSurface) with the name that legends show.
template <class Data>
struct PlotSeries {
  SeriesRole role = SeriesRole::measured;
  QString name;
  Data data;
};
template <class Data>
using PlotSeriesList = std::vector<PlotSeries<Data>>;

/// What all plots of a view have in common.
struct PlotSettings {
  plots::Channel channel = plots::Channel::luminance;
  bool logarithmic = false;
  plots::CosineFactor cosine = plots::CosineFactor::none;
  double thetaI = radians(45);  ///< angle of incidence, rad

  bool operator==(const PlotSettings&) const = default;
};

/// Angles of incidence that plots offer, rad: at 90 degrees nothing is defined.
inline constexpr double maxThetaI = radians(89);

}  // namespace gonio::widgets
