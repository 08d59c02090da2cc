// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>

#include "core/plots/plotted_values.h"
#include "core/plots/value_scale.h"
#include "widgets/plots/plot.h"

class QCustomPlot;
class QCPAxisRect;
class QCPColorMap;
class QCPColorScale;
class QCPItemStraightLine;
class QCPMarginGroup;
class QCPTextElement;

namespace gonio::widgets {

/// Slices of one of the spaces plots::SliceCoordinates side by side, in false colour with one colour bar. Hatched:
/// below the horizon; plain grey: not measured. A draggable line marks the angle of incidence theta_i, whose mirror
/// direction is at the left edge. Wheel and drag zoom and pan all slices together.
class SlicePlot final : public Plot {
  Q_OBJECT

 public:
  explicit SlicePlot(QWidget* parent = nullptr);
  ~SlicePlot() override;

  /// @param series all of the same size, coordinates, spacing and azimuth.
  void setSeries(PlotSeriesList<plots::Slice> series);
  const PlotSeriesList<plots::Slice>& series() const { return m_series; }

  /// Draws the whole slices, independently of zoom and pan.
  void drawOn(QPaintDevice& device, const QSize& size, const PlotStyle& style) override;
  io::CsvTable table() const override;
  bool isEmpty() const override { return m_series.empty(); }
  void resetView() override;
  /// Position of a point of a slice in the widget, by its coordinates: rad, or |Dp|.
  QPointF position(std::size_t slice, double across, double up) const;

 protected:
  void refresh() override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Panel {
    QCPAxisRect* rect;
    QCPTextElement* title;
    QCPColorMap *values, *notMeasured;
    QCPItemStraightLine* line;
  };
  void buildPanels();
  void addPanel(int column);
  void fillPanel(const Panel& panel, const plots::Slice& slice);
  void apply(const PlotStyle& style);
  void setRanges();
  std::optional<std::size_t> panelAt(const QPointF& position) const;
  double upAt(const Panel& panel, const QPointF& position) const;
  bool isOnLine(const QPointF& position) const;
  void pointerMoved(const QPointF& position);

  PlotSeriesList<plots::Slice> m_series;
  plots::ValueScale m_scale;
  double m_largest = 0;  ///< maximum of all panels, may exceed the scale
  QCustomPlot* m_chart;
  QCPMarginGroup* m_margins;
  QCPColorScale* m_bar;
  std::vector<Panel> m_panels;
  bool m_viewChanged = false, m_draggingLine = false;
};

}  // namespace gonio::widgets
