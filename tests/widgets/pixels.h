// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QPixmap>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <cstdlib>

/// Colours in the picture of a widget.
namespace gonio::test {

/// But for smoothing: no channel differs by more than 80 of 255.
inline bool isNear(const QColor& a, const QColor& b) {
  return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())}) <= 80;
}

/// The fraction of the directions about a place in which a colour is met within a pixel of the radius.
inline double colouredAround(QWidget& widget, const QPointF& place, double radius, const QColor& colour) {
  const QImage picture = widget.grab().toImage();
  constexpr int directions = 72;
  int met = 0;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2 * M_PI * i / directions;
    bool found = false;
    for (const double r : {radius - 1, radius - 0.5, radius, radius + 0.5, radius + 1}) {
      const QPoint at(int(std::floor(place.x() + r * std::cos(angle))),
                      int(std::floor(place.y() + r * std::sin(angle))));
      found = found || (picture.rect().contains(at) && isNear(picture.pixelColor(at), colour));
    }
    met += found;
  }
  return double(met) / directions;
}

}  // namespace gonio::test
