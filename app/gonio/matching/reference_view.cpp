// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/matching/reference_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace gonio::app {

namespace {
/// Distance from the outline within which a drag changes the radius, pixels.
constexpr double rimReach = 8;
}  // namespace

ReferenceView::ReferenceView(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setAccessibleName(tr("Reference image"));
  setHasOutline(true);
}

void ReferenceView::setHasOutline(bool hasOutline) {
  m_hasOutline = hasOutline;
  setToolTip(hasOutline ? tr("The circle is the outline of the sphere: drag its inside to move it, its outline to "
                             "resize it")
                        : QString());
  if (!hasOutline) setCursor(Qt::ArrowCursor);
  update();
}

void ReferenceView::setImage(const QImage& image, const matching::Disc& disc, const QSize& size) {
  m_image = image;
  m_size = size.isValid() ? size : image.size();
  m_disc = disc;
  if (m_dragged == Part::none) m_placed = disc;
  update();
}

void ReferenceView::setShownRadius(double pixels) {
  m_radius = pixels;
  update();
}

double ReferenceView::scale() const { return m_radius / m_placed.radius; }

QPointF ReferenceView::toWidget(const QPointF& place) const {
  return QPointF(width(), height()) / 2 + scale() * (place - QPointF(m_placed.x, m_placed.y));
}

void ReferenceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(46, 46, 48));
  if (m_image.isNull()) return;
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.drawImage(QRectF(toWidget({0, 0}), scale() * QSizeF(m_size)), m_image);
  if (!m_hasOutline) return;
  const QPointF centre = toWidget({m_disc.x, m_disc.y});
  const double radius = scale() * m_disc.radius;
  painter.setBrush(Qt::NoBrush);
  // Visible on light and on dark images.
  painter.setPen(QPen(QColor(0, 0, 0, 160), 3));
  painter.drawEllipse(centre, radius, radius);
  painter.setPen(QPen(QColor(255, 255, 255, 220), 1, m_dragged == Part::none ? Qt::DashLine : Qt::SolidLine));
  painter.drawEllipse(centre, radius, radius);
}

ReferenceView::Part ReferenceView::partAt(const QPointF& position) const {
  if (m_image.isNull() || !m_hasOutline) return Part::none;
  const QPointF offset = position - toWidget({m_disc.x, m_disc.y});
  const double distance = std::hypot(offset.x(), offset.y()), radius = scale() * m_disc.radius;
  if (std::abs(distance - radius) <= rimReach) return Part::rim;
  return distance < radius ? Part::centre : Part::none;
}

void ReferenceView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  m_dragged = partAt(event->position());
  m_start = event->position();
  m_pressed = m_disc;
}

void ReferenceView::mouseMoveEvent(QMouseEvent* event) {
  if (m_dragged == Part::none) {
    const Part part = partAt(event->position());
    setCursor(part == Part::rim ? Qt::SizeHorCursor : part == Part::centre ? Qt::SizeAllCursor : Qt::ArrowCursor);
    return;
  }
  matching::Disc disc = m_pressed;
  if (m_dragged == Part::centre) {
    const QPointF moved = (event->position() - m_start) / scale();
    disc.x = std::clamp(disc.x + moved.x(), 0.0, double(m_size.width()));
    disc.y = std::clamp(disc.y + moved.y(), 0.0, double(m_size.height()));
  } else {
    const QPointF offset = event->position() - toWidget({disc.x, disc.y});
    disc.radius = std::max(matching::minDiscRadius, std::hypot(offset.x(), offset.y()) / scale());
  }
  Q_EMIT discDragged(disc);
}

void ReferenceView::mouseReleaseEvent(QMouseEvent*) {
  m_dragged = Part::none;
  m_placed = m_disc;
  update();
}

}  // namespace gonio::app

#include "moc_reference_view.cpp"
