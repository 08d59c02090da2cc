// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_input.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "widgets/preview/preview_navigation.h"

namespace gonio::widgets {

namespace {

/// Whether a drag moves the light: there is one alone, and it is distant.
bool hasMovableLight(const Scene& scene) { return scene.directionalLights.size() == 1 && lightsOf(scene).size() == 1; }

}  // namespace

PreviewInput::PreviewInput(PreviewContent& content, QWidget& viewport)
    : QObject(&viewport), m_content(content), m_viewport(viewport) {
  viewport.installEventFilter(this);
}

bool PreviewInput::eventFilter(QObject*, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      press(*static_cast<QMouseEvent*>(event));
      return true;
    case QEvent::MouseMove:
      move(*static_cast<QMouseEvent*>(event));
      return true;
    case QEvent::Wheel: {
      const double steps = static_cast<QWheelEvent*>(event)->angleDelta().y() / 120.0;
      m_content.setView(zoomed(m_content.scene().camera, steps), m_content.scene().environmentRotation);
      event->accept();
      return true;
    }
    case QEvent::KeyPress:
      return key(*static_cast<QKeyEvent*>(event));
    default:
      return false;
  }
}

void PreviewInput::setPicking(bool picking) {
  m_picking = picking;
  m_viewport.setCursor(picking ? Qt::CrossCursor : Qt::ArrowCursor);
}

void PreviewInput::frameObject() {
  OrbitCamera camera = m_content.scene().camera;
  camera.distance = m_content.home().camera.distance;
  camera.target = m_content.home().camera.target;
  m_content.setView(camera, m_content.scene().environmentRotation);
}

void PreviewInput::resetView() {
  const Scene& home = m_content.home();
  Scene scene = m_content.scene();
  scene.camera = home.camera;
  scene.environmentRotation = home.environmentRotation;
  if (hasMovableLight(scene))
    scene.directionalLights = hasMovableLight(home) ? home.directionalLights : std::vector{DirectionalLight{}};
  m_content.setScene(scene);
}

PreviewInput::PicturePosition PreviewInput::picturePosition(const QPointF& position) const {
  const bool halved = m_content.isComparing() && m_content.comparison().mode == CompareMode::twoUp;
  const double wide = halved ? m_viewport.width() / 2.0 : m_viewport.width();
  const double x = position.x() < wide ? position.x() : position.x() - (halved ? wide : 0);
  return {2 * x / wide - 1, 1 - 2 * position.y() / m_viewport.height(), wide / m_viewport.height()};
}

bool PreviewInput::pick(const QMouseEvent& event) {
  if (!(event.buttons() & Qt::LeftButton) || !(m_picking || event.modifiers() & Qt::ControlModifier)) return false;
  const PicturePosition at = picturePosition(event.position());
  if (const auto theta = viewerPolarAngle(m_content.scene().camera, at.x, at.y, at.aspect))
    Q_EMIT polarAnglePicked(*theta);
  return true;
}

void PreviewInput::press(const QMouseEvent& event) {
  m_lastPosition = event.position();
  if (pick(event)) return;
  if (event.button() == Qt::LeftButton && hasMovableLight(m_content.scene())) dragLight(event.position());
}

void PreviewInput::move(const QMouseEvent& event) {
  const QPointF delta = event.position() - m_lastPosition;
  m_lastPosition = event.position();
  if (pick(event)) return;
  const Scene& scene = m_content.scene();
  if (event.buttons() & Qt::LeftButton && hasMovableLight(scene)) return dragLight(event.position());
  if (event.buttons() & Qt::RightButton && event.modifiers() & Qt::ShiftModifier)
    m_content.setView(scene.camera, scene.environmentRotation + environmentTurn(delta.x()));
  else if (event.buttons() & (Qt::LeftButton | Qt::MiddleButton | Qt::RightButton))
    m_content.setView(orbited(scene.camera, delta.x(), delta.y()), scene.environmentRotation);
}

void PreviewInput::dragLight(const QPointF& position) {
  Scene scene = m_content.scene();
  const PicturePosition at = picturePosition(position);
  scene.directionalLights.front().toLight = lightTowards(scene.camera, at.x, at.y, at.aspect);
  m_content.setScene(scene);
}

bool PreviewInput::key(const QKeyEvent& event) {
  const double step = event.modifiers() & Qt::ShiftModifier ? 2 : 20;  // pixels of a drag
  OrbitCamera camera = m_content.scene().camera;
  switch (event.key()) {
    case Qt::Key_F:
      frameObject();
      return true;
    case Qt::Key_R:
      resetView();
      return true;
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
      return false;
  }
  m_content.setView(camera, m_content.scene().environmentRotation);
  return true;
}

}  // namespace gonio::widgets

#include "moc_preview_input.cpp"
