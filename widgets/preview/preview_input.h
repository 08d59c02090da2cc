// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPointF>
#include <QWidget>

#include "widgets/preview/preview_content.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace gonio::widgets {

/// What the hand does to the preview. Left drag orbits (with one distant light alone: moves the light), right drag
/// orbits always, middle or Shift + left drag pans, the wheel zooms to the pointer, Shift + right drag turns the
/// environment, Ctrl + left (or left alone while picking) picks the angle of the viewer at a point, a right click asks
/// for a menu. By keys: arrows orbit, with Ctrl they pan, plus and minus zoom, F frames, R resets the view.
class PreviewInput : public QObject {
  Q_OBJECT

 public:
  /// Takes the viewport's mouse, wheel and keys.
  PreviewInput(PreviewContent& content, QWidget& viewport);

  /// While picking, a left click or drag picks as Ctrl + left does.
  void setPicking(bool picking);
  void frameObject();
  void resetView();

 Q_SIGNALS:
  /// The user points at the sphere where the viewer stands at this polar angle (rad, [0, pi/2]).
  void polarAnglePicked(double theta);
  /// By a click with the right button, or by the menu key. @param place global
  void menuRequested(const QPoint& place);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct PicturePosition {
    double x, y, aspect;  ///< x, y in [-1, 1], y up
  };
  PicturePosition picturePosition(const QPointF& position) const;
  /// The place, or a distance, in halves of the picture's smaller side, y up.
  QPointF inHalfSides(const QPointF& pixels) const;
  void press(const QMouseEvent& event);
  void move(const QMouseEvent& event);
  void release(const QMouseEvent& event);
  bool key(const QKeyEvent& event);
  bool pick(const QMouseEvent& event);
  void dragLight(const QPointF& position);

  PreviewContent& m_content;
  QWidget& m_viewport;
  bool m_picking = false;
  QPointF m_lastPosition;
  bool m_moved = false;  ///< since a button was pressed
};

}  // namespace gonio::widgets
