// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/acquisition/sample_chart.h"

namespace gonio::widgets {

/// The hemisphere seen from above, its polar angle even along the radius: light and viewer of each sample as two dots
/// that a thin line joins, with rings of the polar angle and rays of the azimuth.
class HemisphereChart : public SampleChart {
  Q_OBJECT

 public:
  explicit HemisphereChart(QWidget* parent = nullptr);

  /// What lies beyond is shaded: no arm gets there. rad
  void setLargestPolarAngle(double angle);
  double largestPolarAngle() const { return m_largestPolarAngle; }

  /// Where a direction is drawn, in the widget's pixels.
  QPointF placeOf(const Direction& direction) const;
  /// The light, then the viewer.
  QList<QPointF> places(int sample) const override;

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QRectF disc() const;
  void drawGrid(QPainter& painter) const;
  void drawLabels(QPainter& painter) const;
  /// What the rings are, and where it stands.
  std::vector<std::pair<QString, QRectF>> ringLabels() const;
  void drawSample(QPainter& painter, int sample, bool marked) const;
  QString beyondText() const;
  int legendRows() const;
  void drawLegend(QPainter& painter) const;

  double m_largestPolarAngle = halfPi;
};

}  // namespace gonio::widgets
