// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/acquisition/sample_chart.h"

namespace gonio::widgets {

/// The hemisphere seen from above, with the polar angle linear along the radius. Light and viewer of each sample are
/// two dots joined by a thin line; rings show the polar angle, rays the azimuth.
class HemisphereChart : public SampleChart {
  Q_OBJECT

 public:
  explicit HemisphereChart(QWidget* parent = nullptr);

  /// Shades larger polar angles, which the rig cannot reach. Rad.
  void setMaxPolarAngle(double angle);
  double maxPolarAngle() const { return m_maxPolarAngle; }

  /// Position of a direction, in widget pixels.
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
  /// Labels of azimuths and rings, and their positions.
  std::vector<std::pair<QString, QRectF>> labels() const;
  std::vector<std::pair<QString, QRectF>> ringLabels() const;
  void drawSample(QPainter& painter, int sample, bool marked) const;
  QString beyondText() const;
  int legendRows() const;
  void drawLegend(QPainter& painter) const;

  double m_maxPolarAngle = halfPi;
};

}  // namespace gonio::widgets
