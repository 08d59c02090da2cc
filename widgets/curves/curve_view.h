// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QRectF>
#include <QString>
#include <QWidget>
#include <array>
#include <vector>

#include "widgets/charts/plot_style.h"

class QPainter;

namespace gonio::widgets {

/// One curve per colour channel, over common nodes.
using ChannelCurves = std::array<std::vector<double>, 3>;

/// Texts and units of a curve's axis.
struct CurveAxis {
  QString title;            ///< above the chart, e.g. "F1: specular strength vs. angle"
  QString label;            ///< with unit, e.g. "θR in degrees"
  QString symbol;           ///< before the number of a position, e.g. "θR"
  QString suffix;           ///< after the number, e.g. "°"
  QString valueLabel;       ///< with its unit
  QString help;             ///< additional text of the tooltip
  double unit = 1;          ///< unit of the labels, in units of the nodes (pi / 180 for degrees)
  double tick = 1;          ///< distance of the labels, in that unit
  bool squareRoot = false;  ///< whether the axis is magnified near 0

  /// A position as text, e.g. "θR 45°".
  QString place(double at) const;
};

/// A vertical line with a name.
struct CurveLimit {
  double place;
  QString name;
};

/// Geometry and style of the values in a chart.
class CurveView {
 public:
  CurveAxis axis;
  double last = 1;           ///< of the nodes
  double low = 0, high = 1;  ///< of the values
  bool logarithmic = false;
  QRectF area;  ///< in pixels
  std::vector<CurveLimit> limits;
  double reach = 1e300;  ///< greyed out beyond

  /// Sets the range for curves: from 0, or four decades below the largest value on a logarithmic scale.
  void fitTo(const ChannelCurves& curves, const ChannelCurves& ghost);
  double toX(double place) const;
  double toPlace(double x) const;
  double toY(double value) const;
  double toValue(double y) const;

  void drawFrame(QPainter& painter, const PlotStyle& style) const;
  /// Draws the limits, over the curves.
  void drawLimits(QPainter& painter, const PlotStyle& style) const;
  void drawCurve(QPainter& painter, const std::vector<double>& nodes, const std::vector<double>& curve,
                 const QPen& pen) const;
};

/// Faint pen for the curve of a channel before any edit.
QPen ghostPen(int channel, const PlotStyle& style, double opacity);
/// Pen of the mean of the channels.
QPen meanPen(const PlotStyle& style);

/// Legend of curve editors in one row: the channels, their mean, the measured curves.
class CurveLegend : public QWidget {
  Q_OBJECT

 public:
  explicit CurveLegend(QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QStringList names() const;
};

}  // namespace gonio::widgets
