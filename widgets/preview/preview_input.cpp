// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_input.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/rendering/shape.h"

namespace gonio::widgets {

namespace {
constexpr double orbitPerPixel = 0.008;  // rad
constexpr double maxPitch = 1.5;         // rad: short of the pole, where yaw loses its meaning
constexpr double nearestDistance = 1.2, farthestDistance = 40, farthestTarget = 10;
constexpr double zoomPerStep = 1.12;
}  // namespace

rendering::OrbitCamera orbited(const rendering::OrbitCamera& camera, double dx, double dy) {
  rendering::OrbitCamera result = camera;
  result.yaw = std::remainder(camera.yaw - orbitPerPixel * dx, 2 * pi);
  result.pitch = std::clamp(camera.pitch + orbitPerPixel * dy, -maxPitch, maxPitch);
  return result;
}

rendering::OrbitCamera panned(const rendering::OrbitCamera& camera, double x, double y) {
  const rendering::CameraFrame frame = rendering::cameraFrame(camera);
  const double atTarget = frame.halfExtent * (frame.orthographic ? 1 : camera.distance);
  rendering::OrbitCamera result = camera;
  result.target -= atTarget * (x * frame.right + y * frame.up);
  for (int axis = 0; axis < 3; ++axis)
    result.target[axis] = std::clamp(result.target[axis], -farthestTarget, farthestTarget);
  return result;
}

rendering::OrbitCamera zoomed(const rendering::OrbitCamera& camera, double steps, double x, double y) {
  rendering::OrbitCamera result = camera;
  result.distance = std::clamp(camera.distance * std::pow(zoomPerStep, -steps), nearestDistance, farthestDistance);
  if (rendering::cameraFrame(camera).orthographic) return result;
  const double ratio = camera.distance / result.distance;
  return panned(result, x * (1 - ratio), y * (1 - ratio));
}

double environmentTurn(double dx) { return orbitPerPixel * dx; }

Direction lightTowards(const rendering::OrbitCamera& camera, double x, double y, double aspect) {
  const Ray ray = rendering::cameraRay(rendering::cameraFrame(camera), x, y, aspect);
  const Direction closest = ray.origin - glm::dot(ray.origin, ray.direction) * ray.direction;
  const std::optional<rendering::ShapeHit> hit = rendering::nearestHit(rendering::Sphere{}, ray);
  const Direction normal = hit ? hit->shadingNormal : glm::normalize(closest);
  return glm::normalize(ray.direction - 2 * glm::dot(ray.direction, normal) * normal);
}

std::optional<double> viewerPolarAngle(const rendering::OrbitCamera& camera, double x, double y, double aspect) {
  const Ray ray = rendering::cameraRay(rendering::cameraFrame(camera), x, y, aspect);
  const std::optional<rendering::ShapeHit> hit = rendering::nearestHit(rendering::Sphere{}, ray);
  if (!hit) return std::nullopt;
  const Direction& normal = hit->shadingNormal;
  return std::atan2(glm::length(glm::cross(normal, ray.direction)), std::max(0.0, -glm::dot(normal, ray.direction)));
}

namespace {

/// Whether a drag moves the light: there is one alone, and it is distant.
bool hasMovableLight(const rendering::Scene& scene) {
  return scene.directionalLights.size() == 1 && lightsOf(scene).size() == 1;
}

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
      const auto* wheel = static_cast<QWheelEvent*>(event);
      const PicturePosition at = picturePosition(wheel->position());
      const double wide = std::max(1.0, at.aspect), high = std::max(1.0, 1 / at.aspect);
      m_content.setView(zoomed(m_content.scene().camera, wheel->angleDelta().y() / 120.0, at.x * wide, at.y * high),
                        m_content.scene().environmentRotation);
      event->accept();
      return true;
    }
    case QEvent::MouseButtonRelease:
      release(*static_cast<QMouseEvent*>(event));
      return true;
    case QEvent::ContextMenu: {
      const auto* menu = static_cast<QContextMenuEvent*>(event);
      // That of the mouse comes at the press: a drag may follow.
      if (menu->reason() == QContextMenuEvent::Keyboard)
        Q_EMIT menuRequested(m_viewport.mapToGlobal(m_viewport.rect().center()));
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
  rendering::OrbitCamera camera = m_content.scene().camera;
  camera.distance = m_content.home().camera.distance;
  camera.target = m_content.home().camera.target;
  m_content.setView(camera, m_content.scene().environmentRotation);
}

void PreviewInput::resetView() {
  const rendering::Scene& home = m_content.home();
  rendering::Scene scene = m_content.scene();
  scene.camera = home.camera;
  scene.environmentRotation = home.environmentRotation;
  if (hasMovableLight(scene))
    scene.directionalLights =
        hasMovableLight(home) ? home.directionalLights : std::vector{rendering::DirectionalLight{}};
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
  m_moved = false;
  if (event.button() == Qt::LeftButton && event.modifiers() & Qt::AltModifier) {
    m_editPressed = event.position();
    Q_EMIT editStarted(event.position());
    return;
  }
  if (pick(event)) return;
  if (event.button() == Qt::LeftButton && !(event.modifiers() & Qt::ShiftModifier) &&
      hasMovableLight(m_content.scene()))
    dragLight(event.position());
}

void PreviewInput::release(const QMouseEvent& event) {
  if (m_editPressed && event.button() == Qt::LeftButton) {
    m_editPressed.reset();
    Q_EMIT editFinished();
    return;
  }
  if (event.button() == Qt::RightButton && !m_moved) Q_EMIT menuRequested(event.globalPosition().toPoint());
}

QPointF PreviewInput::inHalfSides(const QPointF& pixels) const {
  const bool halved = m_content.isComparing() && m_content.comparison().mode == CompareMode::twoUp;
  const double half = std::min(m_viewport.width() / (halved ? 2.0 : 1.0), double(m_viewport.height())) / 2;
  return {pixels.x() / half, -pixels.y() / half};
}

void PreviewInput::move(const QMouseEvent& event) {
  const QPointF delta = event.position() - m_lastPosition;
  // A click is allowed to tremble.
  if (!m_moved && event.buttons() == Qt::RightButton && 2 * delta.manhattanLength() < QApplication::startDragDistance())
    return;
  m_moved = true;
  m_lastPosition = event.position();
  if (m_editPressed) {
    Q_EMIT editDragged(event.position() - *m_editPressed, event.globalPosition().toPoint());
    return;
  }
  if (pick(event)) return;
  const rendering::Scene& scene = m_content.scene();
  const bool shift = event.modifiers() & Qt::ShiftModifier;
  if (event.buttons() & Qt::MiddleButton || (event.buttons() & Qt::LeftButton && shift)) {
    const QPointF way = inHalfSides(delta);
    return m_content.setView(panned(scene.camera, way.x(), way.y()), scene.environmentRotation);
  }
  if (event.buttons() & Qt::LeftButton && hasMovableLight(scene)) return dragLight(event.position());
  if (event.buttons() & Qt::RightButton && shift)
    m_content.setView(scene.camera, scene.environmentRotation + environmentTurn(delta.x()));
  else if (event.buttons() & (Qt::LeftButton | Qt::RightButton))
    m_content.setView(orbited(scene.camera, delta.x(), delta.y()), scene.environmentRotation);
}

void PreviewInput::dragLight(const QPointF& position) {
  rendering::Scene scene = m_content.scene();
  const PicturePosition at = picturePosition(position);
  scene.directionalLights.front().toLight = lightTowards(scene.camera, at.x, at.y, at.aspect);
  m_content.setScene(scene);
}

bool PreviewInput::key(const QKeyEvent& event) {
  const double step = event.modifiers() & Qt::ShiftModifier ? 2 : 20;  // pixels of a drag
  rendering::OrbitCamera camera = m_content.scene().camera;
  const auto moved = [&](double dx, double dy) {
    if (!(event.modifiers() & Qt::ControlModifier)) return orbited(camera, dx, dy);
    const QPointF way = inHalfSides({dx, dy});
    return panned(camera, way.x(), way.y());
  };
  switch (event.key()) {
    case Qt::Key_Escape:
      if (!m_editPressed) return false;
      Q_EMIT editDragged({}, m_viewport.mapToGlobal(m_editPressed->toPoint()));
      m_editPressed.reset();
      Q_EMIT editFinished();
      return true;
    case Qt::Key_F:
      frameObject();
      return true;
    case Qt::Key_R:
      resetView();
      return true;
    case Qt::Key_Left:
      camera = moved(-step, 0);
      break;
    case Qt::Key_Right:
      camera = moved(step, 0);
      break;
    case Qt::Key_Up:
      camera = moved(0, -step);
      break;
    case Qt::Key_Down:
      camera = moved(0, step);
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
