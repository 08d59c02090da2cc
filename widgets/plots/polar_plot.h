// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>

#include "widgets/plots/plot.h"
#include "widgets/plots/polar_drawing.h"

namespace gonio::widgets {

/// The lobe in the plane of incidence: the radius is the value at the signed polar angle of the viewer. Dragging the
/// arrow of the light changes the angle of incidence; dragging elsewhere pans; the wheel zooms.
class PolarPlot : public Plot {
  Q_OBJECT

 public:
  explicit PolarPlot(QWidget* parent = nullptr);

  /// Curves over theta_o in the plane of incidence (plots::polarLobe).
  void setSeries(PlotSeriesList<plots::Curve> series);
  const PlotSeriesList<plots::Curve>& series() const { return m_series; }

  void drawOn(QPaintDevice& device, const QSize& size, const PlotStyle& style) override;
  io::CsvTable table() const override;
  bool isEmpty() const override { return m_series.empty(); }
  void resetView() override;
  /// Position of the light's handle, in the widget's coordinates.
  QPointF handle() const;

 protected:
  void refresh() override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  enum class Drag { none, light, pan };
  PolarGeometry geometry(const QSize& size) const;
  bool isOnLight(const QPointF& position) const;
  void showValuesAt(const QPointF& position);
  void drawCrosshair(QPainter& painter) const;
  void draw(QPainter& painter, const QSize& size, const PlotStyle& style) const;

  PlotSeriesList<plots::Curve> m_series;
  plots::ValueScale m_scale;
  double m_zoom = 1;
  QPointF m_pan;  ///< displacement of the centre, in radii of the unzoomed disc
  Drag m_drag = Drag::none;
  QPointF m_lastPosition;
  std::optional<double> m_pointed;  ///< theta_o under the pointer, rad
};

}  // namespace gonio::widgets
