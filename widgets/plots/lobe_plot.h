// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPainter>

#include "core/plots/plotted_values.h"
#include "core/plots/value_scale.h"
#include "widgets/charts/plot_style.h"
#include "widgets/plots/plot.h"
#include "widgets/plots/plot_series.h"

namespace gonio::widgets {

/// The view of a lobe: an orthographic projection with the normal upwards.
struct LobeView {
  double yaw = radians(-65);   ///< azimuth of the eye, rad; at -90 degrees it looks across the plane of incidence, with
                               ///< the mirror direction on the right
  double pitch = radians(22);  ///< rad above the surface, (-pi/2, pi/2)
  double zoom = 1;

  Direction toEye() const;
  Direction right() const;
  Direction up() const;
};

/// Position and size of a lobe in a picture.
struct LobePlace {
  LobeView view;
  QPointF centre;
  double radius = 1;  ///< of the unit hemisphere, pixels

  static LobePlace filling(const QRectF& cell, double fontHeight, const LobeView& view);
  QPointF at(const Direction& point) const;
};

struct LobePicture {
  const PlotSeries<plots::LobeSurface>& series;
  PlotSettings settings;
  plots::ValueScale scale;
};

/// Draws the surface, the normal, the light and mirror directions, the name of the series, and a circle in the plane of
/// the material with the value that its radius stands for. The surface consists of shaded quadrilaterals, drawn from
/// back to front, so that it can be exported as SVG.
void drawLobe(QPainter& painter, const QRectF& cell, const LobePlace& place, const LobePicture& picture,
              const PlotStyle& style);

/// A point of the surface: its direction times its value.
Direction lobePoint(const LobePicture& picture, std::size_t index);

/// The whole lobes for one light direction, side by side at the same scale. A drag or Ctrl + arrow keys rotate all of
/// them, the wheel or plus and minus zoom.
class LobePlot final : public Plot {
  Q_OBJECT

 public:
  explicit LobePlot(QWidget* parent = nullptr);

  void setSeries(PlotSeriesList<plots::LobeSurface> series);
  const PlotSeriesList<plots::LobeSurface>& series() const { return m_series; }
  const LobeView& view() const { return m_view; }

  void drawOn(QPaintDevice& device, const QSize& size, const PlotStyle& style) override;
  io::CsvTable table() const override;
  bool isEmpty() const override { return m_series.empty(); }
  void resetView() override;

 protected:
  void refresh() override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRectF cell(const QSize& size, std::size_t index) const;
  LobePlace place(const QSize& size, std::size_t index) const;
  void draw(QPainter& painter, const QSize& size, const PlotStyle& style) const;
  void turn(double dx, double dy);
  void zoom(double steps);
  void showValueAt(const QPointF& position);

  PlotSeriesList<plots::LobeSurface> m_series;
  plots::ValueScale m_scale;
  LobeView m_view;
  QPointF m_lastPosition;
};

}  // namespace gonio::widgets
