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

/// What the hand does to the preview. Left drag orbits (with one distant light alone: moves the light), middle or right
/// drag orbits always, wheel zooms, Shift + right drag turns the environment, Ctrl + left (or left alone while picking)
/// picks the angle of the viewer at a point; arrows, plus, and minus do it by keys, F frames, R resets the view.
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

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct PicturePosition {
    double x, y, aspect;  ///< x, y in [-1, 1], y up
  };
  PicturePosition picturePosition(const QPointF& position) const;
  void press(const QMouseEvent& event);
  void move(const QMouseEvent& event);
  bool key(const QKeyEvent& event);
  bool pick(const QMouseEvent& event);
  void dragLight(const QPointF& position);

  PreviewContent& m_content;
  QWidget& m_viewport;
  bool m_picking = false;
  QPointF m_lastPosition;
};

}  // namespace gonio::widgets
