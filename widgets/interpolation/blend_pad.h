// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QWidget>
#include <vector>

#include "widgets/interpolation/blend_position.h"

namespace gonio::widgets {

/// A corner of the pad.
struct BlendCorner {
  QString name;
  QImage picture;  ///< null: a placeholder disc
};

/// A triangle or square with a material at each corner and a movable point that sets the weights. Mouse: press or drag
/// anywhere (Shift: a tenth; the point snaps to corners), double-click for the middle. Keyboard: arrows (Shift: a
/// tenth), 1 to 4 for a corner, Home or Backspace for the middle. Escape reverts a drag. The weights are shown at the
/// corners and announced to screen readers.
class BlendPad : public QWidget {
  Q_OBJECT

 public:
  explicit BlendPad(QWidget* parent = nullptr);

  /// Sets two (a line) to four corners. The point stays if possible, else moves to the nearest valid place.
  void setCorners(std::vector<BlendCorner> corners);
  int materials() const { return int(m_corners.size()); }
  /// Shows a blend position (blend_position.h), which this class calls its place; emits nothing.
  void setPlace(const QPointF& place);
  QPointF place() const { return m_place; }
  std::vector<double> weights() const { return weightsAt(materials(), m_place); }
  /// The point of the widget, in pixels, at which a place is drawn.
  QPointF position(const QPointF& place) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void interactionStarted();
  void placeEdited(const QPointF& place);
  void interactionEnded();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRectF area() const;
  double pictureSide() const;
  QRectF pictureAt(int corner) const;
  QPointF placeUnder(const QPointF& position) const;
  void moveTo(const QPointF& place);
  /// Moves the point as one complete interaction.
  void jumpTo(const QPointF& place);
  void announce();
  void drawCorners(QPainter& painter) const;
  void drawPoint(QPainter& painter) const;

  std::vector<BlendCorner> m_corners;
  QPointF m_place, m_placeBefore, m_dragFrom, m_dragPosition;
  bool m_dragging = false;
};

/// A weight as text, e.g. "40 %"; with one decimal below 1 % and above 99 %, e.g. "0.3 %".
QString weightText(double weight);

}  // namespace gonio::widgets
