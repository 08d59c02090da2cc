// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>

#include "core/plots/section.h"
#include "widgets/plots/plot.h"

class QCustomPlot;
class QCPItemStraightLine;
class QCPItemText;

namespace gonio::widgets {

/// What the axes of a chart are. Angles in degrees.
struct ChartAxes {
  QString angleTitle, valueTitle;
  double first = 0, last = 90;
  std::string angleColumn;  ///< name in CSV files: "theta_o"
  std::string unit;         ///< of the values in CSV files: "1/sr"
  QString unitText;         ///< behind values, " 1/sr"
  std::string values;       ///< comment in CSV files: what the values are
};

/// Curves over an angle on Cartesian axes: the part that the Cartesian and the albedo plot share. The wheel zooms (over
/// an axis: that axis alone), a drag pans; a line that can be dragged marks the angle of incidence.
class CurveChart : public Plot {
  Q_OBJECT

 public:
  CurveChart(const QString& title, QWidget* parent);

  /// All with the same angles.
  void setSeries(PlotSeriesList<plots::Curve> series);
  const PlotSeriesList<plots::Curve>& series() const { return m_series; }

  void drawOn(QPaintDevice& device, const QSize& size, const PlotStyle& style) override;
  plots::CsvTable table() const override;
  bool isEmpty() const override { return m_series.empty(); }
  void resetView() override;
  /// Where the line of the angle of incidence is, in the widget.
  QPointF handle() const;

 protected:
  virtual ChartAxes axes() const = 0;
  /// Where the angle of incidence lies on the angle axis, degrees; nothing where it does not.
  virtual std::optional<double> incidence() const = 0;
  /// A further line of the table's header.
  virtual std::vector<std::string> fixedForCsv() const { return {}; }
  /// A value at which a horizontal line is drawn.
  virtual std::optional<double> limit() const { return std::nullopt; }

  void refresh() override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void apply(const PlotStyle& style);
  void applyScale();
  void fillGraphs();
  bool isOnLine(const QPointF& position) const;
  void pointerMoved(const QPointF& position);
  double angleAt(const QPointF& position) const;

  PlotSeriesList<plots::Curve> m_series;
  QCustomPlot* m_chart;
  QCPItemStraightLine *m_line, *m_crosshair, *m_limit;
  QCPItemText* m_lineLabel;
  bool m_viewChanged = false;  ///< by the user: new curves do not rescale it
  bool m_draggingLine = false;
};

}  // namespace gonio::widgets
