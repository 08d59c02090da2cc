// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/plots/lobe_drawing.h"
#include "widgets/plots/plot.h"

namespace gonio::widgets {

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
