// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>

#include "core/plots/plotted_values.h"
#include "widgets/plots/plot.h"

class QCustomPlot;
class QCPItemStraightLine;
class QCPItemText;

namespace gonio::widgets {

/// Description of a chart's axes. Angles in degrees.
struct ChartAxes {
  QString angleTitle, valueTitle;
  double first = 0, last = 90;
  std::string angleColumn;  ///< name in CSV files, e.g. "theta_o"
  std::string unit;         ///< unit of the values in CSV files, e.g. "1/sr"
  QString unitText;         ///< after values, e.g. " 1/sr"
  std::string values;       ///< comment in CSV files that describes the values
};

/// Curves over an angle on Cartesian axes: the common base of CartesianPlot and AlbedoPlot. The wheel zooms (over an
/// axis: that axis alone), a drag pans. A draggable line marks the angle of incidence.
class CurveChart : public Plot {
  Q_OBJECT

 public:
  CurveChart(const QString& title, QWidget* parent);

  /// @param series all over the same angles.
  void setSeries(PlotSeriesList<plots::Curve> series);
  const PlotSeriesList<plots::Curve>& series() const { return m_series; }

  void drawOn(QPaintDevice& device, const QSize& size, const PlotStyle& style) override;
  io::CsvTable table() const override;
  bool isEmpty() const override { return m_series.empty(); }
  void resetView() override;
  /// Position of the line that marks the angle of incidence, in the widget's coordinates.
  QPointF handle() const;

 protected:
  virtual ChartAxes axes() const = 0;
  /// Position of the angle of incidence on the angle axis, degrees; nullopt if it is not on this axis.
  virtual std::optional<double> incidence() const = 0;
  /// Additional header lines of the table, for fixed angles.
  virtual std::vector<std::string> fixedForCsv() const { return {}; }
  /// Value of a horizontal line; nullopt: no line.
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
  bool m_viewChanged = false;  ///< the user zoomed or panned, so new curves do not rescale the axes
  bool m_draggingLine = false;
};

/// Values over theta_h, theta_d or theta_o. The other angles are fixed, and stated in the title of the axis.
class CartesianPlot final : public CurveChart {
  Q_OBJECT

 public:
  explicit CartesianPlot(QWidget* parent = nullptr);

  /// @param section the section to which the curves belong.
  void setSection(const plots::Section& section, PlotSeriesList<plots::Curve> series);

 protected:
  ChartAxes axes() const override;
  std::optional<double> incidence() const override;
  std::vector<std::string> fixedForCsv() const override;

 private:
  plots::Section m_section;
};

/// Directional albedo against the polar angle: the fraction of light from one direction that is reflected or, by
/// reciprocity, the fraction of uniform light that reaches a viewer. Above the line at 1 a material would reflect more
/// energy than it receives.
class AlbedoPlot final : public CurveChart {
  Q_OBJECT

 public:
  explicit AlbedoPlot(QWidget* parent = nullptr);

 protected:
  ChartAxes axes() const override;
  std::optional<double> incidence() const override { return degrees(settings().thetaI); }
  std::optional<double> limit() const override { return 1; }
};

}  // namespace gonio::widgets
