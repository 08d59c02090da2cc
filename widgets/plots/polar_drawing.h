// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPainter>

#include "core/plots/plotted_values.h"
#include "core/plots/value_scale.h"
#include "widgets/charts/plot_style.h"
#include "widgets/plots/plot_series.h"

namespace gonio::widgets {

/// Layout of a polar plot: a half disc, the normal upwards, theta_o > 0 to the right.
struct PolarGeometry {
  QPointF centre;
  double radius = 1;  ///< distance of the axis' end from the centre, pixels

  /// The half disc that fills a picture, with room for labels of a font of this height.
  static PolarGeometry filling(const QSizeF& size, double fontHeight);
  QPointF at(double angle, double fraction) const;
  /// Signed polar angle of a point, rad, (-pi, pi].
  double angleOf(const QPointF& point) const;
  /// Fraction of the axis at a point: its distance from the centre divided by `radius`.
  double fractionOf(const QPointF& point) const;
};

struct PolarPicture {
  const PlotSeriesList<plots::Curve>& series;
  PlotSettings settings;
  plots::ValueScale scale;
};

/// Draws disc, axes, curves, the light direction with its handle, the mirror direction, legend and title.
void drawPolar(QPainter& painter, const QSizeF& size, const PolarGeometry& geometry, const PolarPicture& picture,
               const PlotStyle& style);

/// Draws line samples and names in the upper left corner.
void drawLegend(QPainter& painter, const std::vector<std::pair<SeriesRole, QString>>& entries, const PlotStyle& style);

}  // namespace gonio::widgets
