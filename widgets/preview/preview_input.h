// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPointF>
#include <QWidget>
#include <optional>

#include "core/rendering/scene.h"
#include "widgets/preview/preview_content.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace gonio::widgets {

/// Navigation of the view, as plain functions without state or widget.

/// The camera after a drag by (dx, dy) pixels, y down: the sphere follows the pointer.
rendering::OrbitCamera orbited(const rendering::OrbitCamera& camera, double dx, double dy);

/// The camera shifted so that points at the target's depth move by (x, y) in the picture (in units of half its smaller
/// side, y up). The target stays near the objects.
rendering::OrbitCamera panned(const rendering::OrbitCamera& camera, double x, double y);

/// The camera after `steps` notches of the wheel; positive moves nearer. The point at the target's depth at (x, y) in
/// the picture (units as in panned()) stays in place.
rendering::OrbitCamera zoomed(const rendering::OrbitCamera& camera, double steps, double x = 0, double y = 0);

/// Rotation of the environment for a drag by dx pixels, rad.
double environmentTurn(double dx);

/// Direction to a light with its mirror highlight on the sphere at a picture position (x, y in [-1, 1], y up); beside
/// the sphere, at its silhouette.
Direction lightTowards(const rendering::OrbitCamera& camera, double x, double y, double aspect);

/// Polar angle of the viewer (rad, [0, pi/2]) at the point of the sphere seen at a picture position (x, y in [-1, 1],
/// y up): the angle between the normal there and the direction to the eye. Nullopt beside the sphere.
std::optional<double> viewerPolarAngle(const rendering::OrbitCamera& camera, double x, double y, double aspect);

/// Mouse and keyboard input of the preview. Left drag orbits (if the only light is one distant light: moves the light),
/// right drag always orbits, middle or Shift + left drag pans, the wheel zooms at the pointer, Shift + right drag
/// rotates the environment, Alt + left drag edits the material, Ctrl + left (or left while picking) picks the viewer's
/// polar angle at a point, a right click requests a menu. Keys: arrows orbit, Ctrl + arrows pan, plus and minus zoom, F
/// frames, R resets the view.
class PreviewInput : public QObject {
  Q_OBJECT

 public:
  /// Handles the mouse, wheel and key events of the viewport.
  PreviewInput(PreviewContent& content, QWidget& viewport);

  /// While picking, a left click or drag picks as Ctrl + left does.
  void setPicking(bool picking);
  void frameObject();
  void resetView();

 Q_SIGNALS:
  /// The user picked a point of the sphere where the viewer has this polar angle (rad, [0, pi/2]).
  void polarAnglePicked(double theta);
  /// Alt + left drag: pressed at a position of the viewport; moved by so many pixels since then (y down), with the
  /// pointer at a global position; released. Escape moves back and releases.
  void editStarted(const QPointF& position);
  void editDragged(const QPointF& pixels, const QPoint& place);
  void editFinished();
  /// Requested by a right click or the menu key. @param place global position
  void menuRequested(const QPoint& place);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct PicturePosition {
    double x, y, aspect;  ///< x, y in [-1, 1], y up
  };
  PicturePosition picturePosition(const QPointF& position) const;
  /// A position or a distance, in units of half the picture's smaller side, y up.
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
  std::optional<QPointF> m_editPressed;  ///< where the drag that edits the material began
  bool m_moved = false;                  ///< whether the mouse moved since a button was pressed
};

}  // namespace gonio::widgets
