// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// How mouse and keyboard move the points of a curve.
#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>

#include "widgets/curves/curve_editor.h"

namespace gonio::widgets {

namespace {
constexpr double pickRadius = 9;  // pixels
constexpr double keyPixels = 10;  // Shift: a tenth
}  // namespace

int CurveEditor::pointAt(const QPointF& position) const {
  int nearest = -1;
  double best = pickRadius;
  for (std::size_t i = 0; i < m_points.size(); ++i) {
    const QPointF away = pointPosition(i) - position;
    const double distance = std::max(std::abs(away.x()), std::abs(away.y()));
    if (distance > best) continue;
    best = distance;
    nearest = int(i);
  }
  return nearest;
}

void CurveEditor::select(int point, bool extend) {
  if (!extend && (point < 0 || !m_selected[std::size_t(point)])) m_selected.assign(m_points.size(), false);
  if (point >= 0) m_selected[std::size_t(point)] = true;
  m_current = point;
  announce();
  update();
}

void CurveEditor::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || m_nodes.empty()) return;
  m_pressed = m_boxEnd = event->position();
  const int point = pointAt(m_pressed);
  select(point, event->modifiers() & Qt::ShiftModifier);
  m_boxing = point < 0;
  m_selectedBefore = m_selected;
  m_dragging = point >= 0;
  if (!m_dragging) return;
  beginDrag();
  Q_EMIT interactionStarted();
}

void CurveEditor::mouseMoveEvent(QMouseEvent* event) {
  if (m_dragging) {
    const bool fine = event->modifiers() & Qt::ShiftModifier;
    dragBy((event->position() - m_pressed) * (fine ? 0.1 : 1.0));
  } else if (m_boxing) {
    m_boxEnd = event->position();
    const QRectF box = QRectF(m_pressed, m_boxEnd).normalized();
    for (std::size_t i = 0; i < m_points.size(); ++i)
      m_selected[i] = m_selectedBefore[i] || box.contains(pointPosition(i));
    update();
  } else {
    hover(event->position());
  }
}

void CurveEditor::hover(const QPointF& position) {
  if (m_nodes.empty()) return;
  if (m_view.area.contains(position)) {
    m_hovered = m_view.toPlace(position.x());
    Q_EMIT pointedAt(*m_hovered);
  } else {
    m_hovered.reset();
  }
  update();
}

void CurveEditor::leaveEvent(QEvent*) {
  m_hovered.reset();
  update();
}

void CurveEditor::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const bool dragged = m_dragging;
  m_dragging = m_boxing = false;
  if (dragged) Q_EMIT interactionEnded();
  layOut();
}

void CurveEditor::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || m_nodes.empty() || pointAt(event->position()) >= 0) return;
  const double place = m_view.toPlace(event->position().x());
  const auto at = std::lower_bound(m_points.begin(), m_points.end(), place);
  if (at != m_points.end() && *at == place) return;
  const auto index = at - m_points.begin();
  m_points.insert(at, place);
  m_selected.assign(m_points.size(), false);
  select(int(index), false);
}

void CurveEditor::removeSelected() {
  for (std::size_t i = m_points.size(); i-- > 0;) {
    const bool isEnd = i == 0 || i + 1 == m_points.size();
    if (!m_selected[i] || isEnd) continue;
    m_points.erase(m_points.begin() + std::ptrdiff_t(i));
    m_selected.erase(m_selected.begin() + std::ptrdiff_t(i));
  }
  select(-1, false);
}

bool CurveEditor::event(QEvent* event) {
  // Delete and Escape are the points' while the curve has the focus, not the menus'.
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool selectAll = static_cast<QKeyEvent*>(event)->matches(QKeySequence::SelectAll);
    if (selectAll || key == Qt::Key_Delete || (key == Qt::Key_Escape && m_current >= 0)) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void CurveEditor::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers() & Qt::ShiftModifier ? keyPixels / 10 : keyPixels;
  QPointF move;
  switch (event->key()) {
    case Qt::Key_Left:
      move.setX(-step);
      break;
    case Qt::Key_Right:
      move.setX(step);
      break;
    case Qt::Key_Up:
      move.setY(-step);
      break;
    case Qt::Key_Down:
      move.setY(step);
      break;
    case Qt::Key_Delete:
      return removeSelected();
    case Qt::Key_Escape:
      if (m_dragging) return cancelDrag();
      if (m_current < 0) return QWidget::keyPressEvent(event);
      return select(-1, false);
    default:
      if (!event->matches(QKeySequence::SelectAll)) return QWidget::keyPressEvent(event);
      m_selected.assign(m_points.size(), true);
      return update();
  }
  if (std::find(m_selected.begin(), m_selected.end(), true) == m_selected.end()) return;
  beginDrag();
  Q_EMIT interactionStarted();
  m_dragging = true;  // the points stay those of the hand while the curves come back
  dragBy(move);
  m_dragging = false;
  Q_EMIT interactionEnded();
  layOut();
}

void CurveEditor::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  if (m_points.empty()) return;
  if (event->reason() == Qt::TabFocusReason) select(0, false);
  if (event->reason() == Qt::BacktabFocusReason) select(int(m_points.size()) - 1, false);
}

bool CurveEditor::focusNextPrevChild(bool next) {
  const int wanted = m_current + (next ? 1 : -1);
  if (m_current < 0 || wanted < 0 || wanted >= int(m_points.size())) return QWidget::focusNextPrevChild(next);
  m_selected.assign(m_points.size(), false);
  select(wanted, false);
  return true;
}

}  // namespace gonio::widgets
