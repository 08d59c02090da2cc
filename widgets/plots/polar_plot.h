// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPainter>
#include <optional>

#include "core/plots/plotted_values.h"
#include "core/plots/value_scale.h"
#include "widgets/charts/plot_style.h"
#include "widgets/plots/plot.h"
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
