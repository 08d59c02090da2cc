// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/split_bar.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace gonio::widgets {

namespace {
constexpr int thickness = 25;
constexpr double handleRadius = 11;
constexpr double step = 0.02, fineStep = 0.002;
}  // namespace

SplitBar::SplitBar(QWidget* parent) : QWidget(parent) {
  setCursor(Qt::SplitHCursor);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Split bar"));
  setToolTip(tr("Drag to move the split; double-click to centre it"));
  parent->installEventFilter(this);
  place();
}

void SplitBar::place() {
  const int centre = int(std::lround(m_position * parentWidget()->width()));
  setGeometry(centre - thickness / 2, 0, thickness, parentWidget()->height());
}

void SplitBar::setPosition(double fraction) {
  m_position = std::clamp(fraction, 0.0, 1.0);
  place();
}

void SplitBar::moveTo(double fraction) {
  const double before = m_position;
  setPosition(fraction);
  if (m_position != before) Q_EMIT moved(m_position);
}

void SplitBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF centre(thickness / 2 + 0.5, height() / 2.0);
  const QColor line(255, 255, 255), edge(0, 0, 0, 150);
  painter.setPen(QPen(edge, 3));
  painter.drawLine(QPointF(centre.x(), 0), QPointF(centre.x(), height()));
  painter.setPen(QPen(line, 1));
  painter.drawLine(QPointF(centre.x(), 0), QPointF(centre.x(), height()));
  painter.setPen(QPen(hasFocus() ? palette().color(QPalette::Highlight) : line, hasFocus() ? 2.5 : 1.5));
  painter.setBrush(QColor(30, 30, 32, 220));
  painter.drawEllipse(centre, handleRadius - 1, handleRadius - 1);
  painter.setPen(Qt::NoPen);
  painter.setBrush(line);
  for (const double side : {-1.0, 1.0})
    painter.drawPolygon(
        QPolygonF{centre + QPointF(side * 3, -4), centre + QPointF(side * 7, 0), centre + QPointF(side * 3, 4)});
}

void SplitBar::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  m_grip = event->position().x() - width() / 2.0;
}

void SplitBar::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton)) return event->ignore();
  moveTo((mapToParent(event->position()).x() - m_grip) / std::max(1, parentWidget()->width()));
}

void SplitBar::mouseDoubleClickEvent(QMouseEvent*) { moveTo(0.5); }

void SplitBar::keyPressEvent(QKeyEvent* event) {
  const double by = event->modifiers() & Qt::ShiftModifier ? fineStep : step;
  switch (event->key()) {
    case Qt::Key_Left:
      return moveTo(m_position - by);
    case Qt::Key_Right:
      return moveTo(m_position + by);
    case Qt::Key_Home:
      return moveTo(0.5);
    default:
      event->ignore();
  }
}

bool SplitBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) place();
  return QWidget::eventFilter(watched, event);
}

}  // namespace gonio::widgets

#include "moc_split_bar.cpp"
