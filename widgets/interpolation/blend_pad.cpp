// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/interpolation/blend_pad.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/interpolation/sphere_picture.h"

namespace gonio::widgets {

namespace {
constexpr double stickyPixels = 7, keyStep = 0.02, fine = 0.1, pointRadius = 7;
constexpr double minPicture = 28, maxPicture = 72, pictureFraction = 0.22;
constexpr int minLines = 9, usualLines = 14;

QChar letter(int corner) { return QChar(u'A' + corner); }
}  // namespace

QString weightText(double weight) {
  const double percent = 100 * weight;
  const bool nearEnd = (percent > 0 && percent < 1) || (percent > 99 && percent < 100);
  return QStringLiteral("%1 %").arg(percent, 0, 'f', nearEnd ? 1 : 0);
}

BlendPad::BlendPad(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::CrossCursor);
  setAccessibleName(tr("Point between the materials"));
  setToolTip(
      tr("Drag the point towards a corner to increase the weight of its material (Shift: fine).\nThe arrow keys move "
         "the point; the keys 1 to 4 move it to a corner, Home or a double-click to the middle.\nThe strip of spheres "
         "shows blends along the dashed line."));
  QSizePolicy square(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setSizePolicy(square);
  setCorners(std::vector<BlendCorner>(3));
}

void BlendPad::setCorners(std::vector<BlendCorner> corners) {
  const bool another = corners.size() != m_corners.size();
  m_corners = std::move(corners);
  if (another) m_place = nearestPosition(materials(), m_place);
  announce();
  update();
}

void BlendPad::setPlace(const QPointF& place) {
  m_place = nearestPosition(materials(), place);
  announce();
  update();
}

QSize BlendPad::sizeHint() const { return QSize(usualLines, usualLines) * fontMetrics().height(); }
QSize BlendPad::minimumSizeHint() const { return QSize(minLines, minLines) * fontMetrics().height(); }

double BlendPad::pictureSide() const {
  return std::clamp(pictureFraction * std::min(width(), height()), minPicture, maxPicture);
}

QRectF BlendPad::area() const {
  const double line = fontMetrics().height(), inset = pictureSide() / 2 + 4;
  const QRectF inside = QRectF(rect()).adjusted(inset, inset, -inset, -inset - line);
  const double side = std::max(1.0, std::min(inside.width(), inside.height()));
  return {inside.center().x() - side / 2, inside.center().y() - side / 2, side, side};
}

QRectF BlendPad::pictureAt(int corner) const {
  const double side = pictureSide();
  const QPointF centre = position(cornerPosition(corner));
  return {centre.x() - side / 2, centre.y() - side / 2, side, side};
}

QPointF BlendPad::position(const QPointF& place) const {
  const QPointF drawn = drawnAt(materials(), place);
  const QRectF square = area();
  return square.topLeft() + QPointF(drawn.x() * square.width(), drawn.y() * square.height());
}

QPointF BlendPad::placeUnder(const QPointF& at) const {
  for (int corner = 0; corner < materials(); ++corner) {
    const QPointF away = position(cornerPosition(corner)) - at;
    if (std::hypot(away.x(), away.y()) < stickyPixels) return cornerPosition(corner);
  }
  const QRectF square = area();
  const QPointF drawn = at - square.topLeft();
  return nearestPosition(materials(),
                         positionDrawnAt(materials(), {drawn.x() / square.width(), drawn.y() / square.height()}));
}

void BlendPad::moveTo(const QPointF& place) {
  if (place == m_place) return;
  m_place = place;
  announce();
  update();
  Q_EMIT placeEdited(m_place);
}

void BlendPad::jumpTo(const QPointF& place) {
  Q_EMIT interactionStarted();
  moveTo(nearestPosition(materials(), place));
  Q_EMIT interactionEnded();
}

void BlendPad::announce() {
  QStringList words;
  const std::vector<double> all = weights();
  for (int i = 0; i < materials(); ++i)
    words << tr("%1 %2").arg(
        m_corners[std::size_t(i)].name.isEmpty() ? QString(letter(i)) : m_corners[std::size_t(i)].name,
        weightText(all[std::size_t(i)]));
  const QString text = words.join(QStringLiteral(", "));
  if (text == accessibleDescription()) return;
  setAccessibleDescription(text);
}

void BlendPad::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  m_placeBefore = m_place;
  m_dragFrom = event->position();
  // A fine drag starts where the point is: it does not jump to the mouse first.
  m_dragPosition = event->modifiers() & Qt::ShiftModifier ? position(m_place) : event->position();
  m_dragging = true;
  Q_EMIT interactionStarted();
  moveTo(placeUnder(m_dragPosition));
}

void BlendPad::mouseMoveEvent(QMouseEvent* event) {
  if (!m_dragging) return;
  m_dragPosition += (event->position() - m_dragFrom) * (event->modifiers() & Qt::ShiftModifier ? fine : 1.0);
  m_dragFrom = event->position();
  moveTo(placeUnder(m_dragPosition));
}

void BlendPad::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !m_dragging) return;
  m_dragging = false;
  update();
  Q_EMIT interactionEnded();
}

void BlendPad::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) jumpTo(centrePosition(materials()));
}

bool BlendPad::event(QEvent* event) {
  // Backspace goes to the middle and Escape takes a drag back: the menus have other actions on these keys.
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Backspace || (key == Qt::Key_Escape && m_dragging)) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void BlendPad::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers() & Qt::ShiftModifier ? keyStep * fine : keyStep;
  const auto by = [&](double x, double y) {
    jumpTo(positionDrawnAt(materials(), drawnAt(materials(), m_place) + QPointF(x, y)));
  };
  const int corner = event->key() - Qt::Key_1;
  if (corner >= 0 && corner < materials()) return jumpTo(cornerPosition(corner));
  switch (event->key()) {
    case Qt::Key_Left:
      return by(-step, 0);
    case Qt::Key_Right:
      return by(step, 0);
    case Qt::Key_Up:
      return by(0, -step);
    case Qt::Key_Down:
      return by(0, step);
    case Qt::Key_Home:
    case Qt::Key_Backspace:
      return jumpTo(centrePosition(materials()));
    case Qt::Key_Escape:
      if (!m_dragging) return QWidget::keyPressEvent(event);
      m_dragging = false;
      moveTo(m_placeBefore);
      Q_EMIT interactionEnded();
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void BlendPad::drawCorners(QPainter& painter) const {
  const std::vector<double> all = weights();
  const double line = fontMetrics().height();
  for (int i = 0; i < materials(); ++i) {
    const QRectF picture = pictureAt(i);
    const BlendCorner& corner = m_corners[std::size_t(i)];
    paintSphere(painter, corner.picture, picture, palette());
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF label(picture.center().x() - 3 * line, picture.bottom(), 6 * line, line);
    painter.drawText(label, Qt::AlignCenter, tr("%1  %2").arg(letter(i)).arg(weightText(all[std::size_t(i)])));
  }
}

void BlendPad::drawPoint(QPainter& painter) const {
  const QPointF at = position(m_place);
  painter.setBrush(palette().color(QPalette::Highlight));
  // Two rings, light and dark: seen on every picture.
  painter.setPen(QPen(Qt::black, 4));
  painter.drawEllipse(at, pointRadius, pointRadius);
  painter.setPen(QPen(Qt::white, 2));
  painter.drawEllipse(at, pointRadius, pointRadius);
}

void BlendPad::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  QPolygonF outline;
  for (const int corner : materials() == maxBlended ? std::vector{0, 1, 3, 2} : std::vector{0, 1, 2})
    if (corner < materials()) outline << position(cornerPosition(corner));
  painter.setPen(QPen(palette().color(hasFocus() ? QPalette::Highlight : QPalette::Mid), hasFocus() ? 2 : 1));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawPolygon(outline);
  QColor quiet = palette().color(QPalette::Text);
  quiet.setAlphaF(0.35f);
  painter.setPen(QPen(quiet, 1, Qt::DashLine));
  painter.drawLine(position(cornerPosition(0)), position(pathPosition(materials(), 1)));
  drawCorners(painter);
  drawPoint(painter);
}

}  // namespace gonio::widgets

#include "moc_blend_pad.cpp"
