// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QWidget>
#include <vector>

#include "widgets/interpolation/blend_place.h"

namespace gonio::widgets {

/// A corner of the pad.
struct BlendCorner {
  QString name;
  QImage picture;  ///< null: a quiet disc
};

/// A triangle or a square with a material at each corner, and a point between them that the hand moves. Mouse: press or
/// drag anywhere (Shift: a tenth as far; the point sticks to a corner), double-click for the middle. Keyboard: arrows
/// (Shift: a tenth), 1 to 4 for a corner, Home or Backspace for the middle. Escape takes a drag back. The weights are
/// written at the corners and announced.
class BlendPad : public QWidget {
  Q_OBJECT

 public:
  explicit BlendPad(QWidget* parent = nullptr);

  /// Two (a line) to four corners. The place stays where it exists, else goes to the nearest one.
  void setCorners(std::vector<BlendCorner> corners);
  int materials() const { return int(m_corners.size()); }
  /// Shows a place (of blend_place.h); emits nothing.
  void setPlace(const QPointF& place);
  QPointF place() const { return m_place; }
  std::vector<double> weights() const { return weightsAt(materials(), m_place); }
  /// Where a place lies on the widget.
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
  /// A whole interaction.
  void jumpTo(const QPointF& place);
  void announce();
  void drawCorners(QPainter& painter) const;
  void drawPoint(QPainter& painter) const;

  std::vector<BlendCorner> m_corners;
  QPointF m_place, m_placeBefore, m_dragFrom, m_dragPosition;
  bool m_dragging = false;
};

/// "40 %": a weight for people; what is not nothing never reads as 0.
QString weightText(double weight);

}  // namespace gonio::widgets
