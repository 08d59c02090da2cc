// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// What the hand does to the preview: mouse, wheel and keys.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "widgets/preview/preview_navigation.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::widgets {

namespace {

/// Whether a drag moves the light: there is one alone, and it is distant.
bool hasMovableLight(const Scene& scene) { return scene.directionalLights.size() == 1 && lightsOf(scene).size() == 1; }

}  // namespace

void PreviewWidget::frameObject() {
  OrbitCamera camera = scene_.camera;
  camera.distance = home_.camera.distance;
  camera.target = home_.camera.target;
  setView(camera, scene_.environmentRotation);
}

void PreviewWidget::resetView() {
  Scene scene = scene_;
  scene.camera = home_.camera;
  scene.environmentRotation = home_.environmentRotation;
  if (hasMovableLight(scene))
    scene.directionalLights = hasMovableLight(home_) ? home_.directionalLights : std::vector{DirectionalLight{}};
  setScene(scene);
}

PreviewWidget::PicturePosition PreviewWidget::picturePosition(const QPointF& position) const {
  const bool halved = isComparing() && comparison_.mode == CompareMode::twoUp;
  const double wide = halved ? width() / 2.0 : width();
  const double x = position.x() < wide ? position.x() : position.x() - (halved ? wide : 0);
  return {2 * x / wide - 1, 1 - 2 * position.y() / height(), wide / height()};
}

bool PreviewWidget::pick(const QMouseEvent& event) {
  if (!(event.buttons() & Qt::LeftButton) || !(picking_ || event.modifiers() & Qt::ControlModifier)) return false;
  const PicturePosition at = picturePosition(event.position());
  if (const auto theta = viewerPolarAngle(scene_.camera, at.x, at.y, at.aspect)) Q_EMIT polarAnglePicked(*theta);
  return true;
}

void PreviewWidget::mousePressEvent(QMouseEvent* event) {
  lastPosition_ = event->position();
  if (pick(*event)) return;
  if (event->button() == Qt::LeftButton && hasMovableLight(scene_)) dragLight(event->position());
}

void PreviewWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF delta = event->position() - lastPosition_;
  lastPosition_ = event->position();
  if (pick(*event)) return;
  if (event->buttons() & Qt::LeftButton && hasMovableLight(scene_)) return dragLight(event->position());
  if (event->buttons() & Qt::RightButton && event->modifiers() & Qt::ShiftModifier)
    setView(scene_.camera, scene_.environmentRotation + environmentTurn(delta.x()));
  else if (event->buttons() & (Qt::LeftButton | Qt::MiddleButton | Qt::RightButton))
    setView(orbited(scene_.camera, delta.x(), delta.y()), scene_.environmentRotation);
}

void PreviewWidget::dragLight(const QPointF& position) {
  Scene scene = scene_;
  const PicturePosition at = picturePosition(position);
  scene.directionalLights.front().toLight = lightTowards(scene.camera, at.x, at.y, at.aspect);
  setScene(scene);
}

void PreviewWidget::wheelEvent(QWheelEvent* event) {
  setView(zoomed(scene_.camera, event->angleDelta().y() / 120.0), scene_.environmentRotation);
  event->accept();
}

void PreviewWidget::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers() & Qt::ShiftModifier ? 2 : 20;  // pixels of a drag
  OrbitCamera camera = scene_.camera;
  switch (event->key()) {
    case Qt::Key_F:
      return frameObject();
    case Qt::Key_R:
      return resetView();
    case Qt::Key_Left:
      camera = orbited(camera, -step, 0);
      break;
    case Qt::Key_Right:
      camera = orbited(camera, step, 0);
      break;
    case Qt::Key_Up:
      camera = orbited(camera, 0, -step);
      break;
    case Qt::Key_Down:
      camera = orbited(camera, 0, step);
      break;
    case Qt::Key_Plus:
      camera = zoomed(camera, 1);
      break;
    case Qt::Key_Minus:
      camera = zoomed(camera, -1);
      break;
    default:
      return QOpenGLWidget::keyPressEvent(event);
  }
  setView(camera, scene_.environmentRotation);
}

}  // namespace gonio::widgets
