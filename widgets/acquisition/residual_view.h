// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QWidget>

namespace gonio::widgets {

/// A map of signed relative differences on a sphere in false colour (rendering::signedColour()), with its colour bar.
/// The sphere has a given radius and is in the middle, so that the map can stand beside an image of the same sphere.
class ResidualView : public QWidget {
  Q_OBJECT

 public:
  /// Half side of the map, in radii of the sphere.
  static constexpr double mapExtent = 1.04;

  explicit ResidualView(QWidget* parent = nullptr);

  /// @param map square, transparent where nothing is known; null: none. @param range the relative difference at the
  /// ends of the colour bar.
  void setMap(const QImage& map, double range);
  const QImage& map() const { return m_map; }
  double range() const { return m_range; }
  /// Shown in the middle while there is no map.
  void setHint(const QString& hint);
  /// @param pixels of the sphere on the screen.
  void setShownRadius(double pixels);
  /// Width of the colour bar with its labels, at the right.
  int barWidth() const;

  QSize minimumSizeHint() const override { return {120, 120}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void drawBar(QPainter& painter) const;

  QImage m_map;
  QString m_hint;
  double m_range = 0, m_radius = 100;
};

}  // namespace gonio::widgets
