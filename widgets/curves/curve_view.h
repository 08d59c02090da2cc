// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QRectF>
#include <QString>
#include <array>
#include <vector>

#include "widgets/charts/plot_style.h"

class QPainter;

namespace gonio::widgets {

/// One curve a colour channel, over shared nodes.
using ChannelCurves = std::array<std::vector<double>, 3>;

/// What a curve is drawn over, for people.
struct CurveAxis {
  QString title;            ///< above the chart: "F1: strength of the mirror"
  QString label;            ///< with its unit: "θR in degrees"
  QString symbol;           ///< of a place, before its number: "θR"
  QString suffix;           ///< behind the number: "°"
  QString valueLabel;       ///< with its unit
  QString help;             ///< more for the tool tip
  double unit = 1;          ///< one unit of the labels in units of the nodes (pi / 180 for degrees)
  double tick = 1;          ///< distance of the labels, in those units
  bool squareRoot = false;  ///< more room near 0

  /// A place in words: "θR 45°".
  QString place(double at) const;
};

/// A vertical line with a name.
struct CurveLimit {
  double place;
  QString name;
};

/// Where values lie in a chart and how they look.
class CurveView {
 public:
  CurveAxis axis;
  double last = 1;           ///< of the nodes
  double low = 0, high = 1;  ///< of the values
  bool logarithmic = false;
  QRectF area;  ///< in pixels
  std::vector<CurveLimit> limits;
  double reach = 1e300;  ///< greyed out beyond

  /// The range for curves: from 0, or four decades below the largest where it is logarithmic.
  void fitTo(const ChannelCurves& curves, const ChannelCurves& ghost);
  double toX(double place) const;
  double toPlace(double x) const;
  double toY(double value) const;
  double toValue(double y) const;

  void drawFrame(QPainter& painter, const PlotStyle& style) const;
  /// Over the curves: what distinguishes places.
  void drawLimits(QPainter& painter, const PlotStyle& style) const;
  void drawCurve(QPainter& painter, const std::vector<double>& nodes, const std::vector<double>& curve,
                 const QPen& pen) const;
};

/// Of a channel (0 red, 1 green, 2 blue): distinguished by its dashes too.
QPen channelPen(int channel, const PlotStyle& style);
/// Of a channel as it was before any edit: faint.
QPen ghostPen(int channel, const PlotStyle& style, double opacity);
/// Of the mean of the channels.
QPen meanPen(const PlotStyle& style);

}  // namespace gonio::widgets
