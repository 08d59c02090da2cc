// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QWidget>

#include "core/matching/sphere_finder.h"

namespace gonio::app {

/// An image of a sphere, scaled so that the sphere has a given radius and is in the middle, with a circle around it.
/// The circle can be dragged: near its outline its radius, inside its centre.
class ReferenceView : public QWidget {
  Q_OBJECT

 public:
  explicit ReferenceView(QWidget* parent = nullptr);

  /// @param size of the image in the pixels of `disc` and toWidget(), if `image` is a reduced version of it.
  void setImage(const QImage& image, const matching::Disc& disc, const QSize& size = {});
  /// Whether there is a circle (default); without one, the image is only placed by the disc.
  void setHasOutline(bool hasOutline);
  /// @param pixels of the sphere on the screen.
  void setShownRadius(double pixels);
  /// From pixels of the image to the widget.
  QPointF toWidget(const QPointF& place) const;
  QSize minimumSizeHint() const override { return {120, 120}; }

 Q_SIGNALS:
  /// The user dragged the circle, and when the drag ends.
  void discDragged(const gonio::matching::Disc& disc);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  enum class Part { none, centre, rim };
  double scale() const;
  Part partAt(const QPointF& position) const;

  QImage m_image;
  QSize m_size;
  matching::Disc m_disc;     ///< of the circle
  matching::Disc m_placed;   ///< the image is placed by this one, so that it stays during a drag
  matching::Disc m_pressed;  ///< at the beginning of the drag
  double m_radius = 100;
  bool m_hasOutline = true;
  Part m_dragged = Part::none;
  QPointF m_start;
};

}  // namespace gonio::app
