// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/interpolation/blend_strip.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <utility>

#include "widgets/interpolation/sphere_picture.h"

namespace gonio::widgets {

namespace {
constexpr double minSide = 30, maxSide = 96, usualSide = 56, sphereGap = 3;
constexpr int minRows = 4, usualRows = 5;
}  // namespace

BlendStrip::BlendStrip(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Methods of blending side by side"));
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void BlendStrip::setSteps(const QStringList& steps) {
  m_steps = steps;
  updateGeometry();
  update();
}

void BlendStrip::setRows(std::vector<Row> rows) {
  m_rows = std::move(rows);
  m_cursor.row = std::clamp(m_cursor.row, 0, std::max(0, int(m_rows.size()) - 1));
  updateGeometry();
  update();
}

void BlendStrip::setRow(int row, Row content) {
  Row& one = m_rows[std::size_t(row)];
  const bool sameName = content.name == one.name;
  one = std::move(content);
  if (sameName) return updateRow(row);
  // The widest name says where the columns stand.
  updateGeometry();
  update();
}

void BlendStrip::setCurrentRow(int row) {
  if (row == m_currentRow) return;
  updateRow(std::exchange(m_currentRow, row));
  updateRow(row);
}

void BlendStrip::setMark(double fraction) {
  if (fraction == m_mark) return;
  m_mark = fraction;
  update(QRectF(0, 0, width(), headerHeight()).toAlignedRect());
}

void BlendStrip::updateRow(int row) { update(rowArea(row).toAlignedRect()); }

void BlendStrip::setEmptyText(const QString& text) {
  m_emptyText = text;
  update();
}

double BlendStrip::labelWidth() const {
  int widest = 0;
  for (const Row& row : m_rows) widest = std::max(widest, fontMetrics().horizontalAdvance(row.name));
  return widest + fontMetrics().height();
}

double BlendStrip::headerHeight() const { return fontMetrics().height() * 1.6; }

double BlendStrip::side() const {
  const double rows = double(std::max<std::size_t>(1, m_rows.size())), steps = double(std::max(1, int(m_steps.size())));
  return std::clamp(
      std::min((width() - labelWidth()) / steps - sphereGap, (height() - headerHeight()) / rows - sphereGap), minSide,
      maxSide);
}

QRectF BlendStrip::rowArea(int row) const {
  const double pitch = side() + sphereGap;
  return {0, headerHeight() + row * pitch, labelWidth() + double(m_steps.size()) * pitch, pitch};
}

QRectF BlendStrip::cell(int row, int step) const {
  const double pitch = side() + sphereGap;
  const QRectF area = rowArea(row);
  return {labelWidth() + step * pitch + sphereGap / 2, area.top() + sphereGap / 2, side(), side()};
}

QSize BlendStrip::sizeHint() const {
  return {int(labelWidth() + double(m_steps.size()) * (usualSide + sphereGap)),
          int(headerHeight() + usualRows * (usualSide + sphereGap))};
}

QSize BlendStrip::minimumSizeHint() const {
  return {int(labelWidth() + double(m_steps.size()) * (minSide + sphereGap)),
          int(headerHeight() + minRows * (minSide + sphereGap))};
}

BlendStrip::Cell BlendStrip::cellAt(const QPointF& position) const {
  for (int row = 0; row < int(m_rows.size()); ++row) {
    if (!rowArea(row).contains(position)) continue;
    for (int step = 0; step < m_steps.size(); ++step)
      if (cell(row, step).contains(position)) return {row, step};
    return {row, -1};
  }
  return {-1, -1};
}

void BlendStrip::mousePressEvent(QMouseEvent* event) {
  const Cell at = cellAt(event->position());
  if (event->button() != Qt::LeftButton || at.row < 0) return;
  m_cursor = {at.row, std::max(0, at.step)};
  update();
  Q_EMIT chosen(at.row, at.step);
}

void BlendStrip::moveCursor(int rows, int steps) {
  if (m_rows.empty() || m_steps.isEmpty()) return;
  m_cursor = {std::clamp(m_cursor.row + rows, 0, int(m_rows.size()) - 1),
              std::clamp(m_cursor.step + steps, 0, int(m_steps.size()) - 1)};
  setAccessibleDescription(tr("%1 at %2").arg(m_rows[std::size_t(m_cursor.row)].name, m_steps[m_cursor.step]));
  update();
}

void BlendStrip::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  moveCursor(0, 0);
}

void BlendStrip::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return moveCursor(0, -1);
    case Qt::Key_Right:
      return moveCursor(0, 1);
    case Qt::Key_Up:
      return moveCursor(-1, 0);
    case Qt::Key_Down:
      return moveCursor(1, 0);
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      if (!m_rows.empty()) Q_EMIT chosen(m_cursor.row, m_cursor.step);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

bool BlendStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const Cell at = cellAt(help->pos());
  if (at.row < 0) {
    QToolTip::hideText();
  } else {
    const Row& row = m_rows[std::size_t(at.row)];
    const QString text = row.failed ? tr("%1\n%2").arg(row.toolTip, row.note) : row.toolTip;
    QToolTip::showText(help->globalPos(), text, this, rowArea(at.row).toRect());
  }
  return true;
}

void BlendStrip::drawRow(QPainter& painter, int row) const {
  const Row& content = m_rows[std::size_t(row)];
  const QRectF area = rowArea(row);
  const bool current = row == m_currentRow;
  if (current) {
    QColor fill = palette().color(QPalette::Highlight);
    fill.setAlphaF(0.18f);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
    painter.setBrush(fill);
    painter.drawRoundedRect(area.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  }
  painter.setPen(palette().color(QPalette::WindowText));
  const QRectF label(area.left() + fontMetrics().height() / 2.0, area.top(), labelWidth(), area.height());
  painter.drawText(label, Qt::AlignLeft | Qt::AlignVCenter, content.name);
  for (int step = 0; step < int(content.pictures.size()); ++step)
    paintSphere(painter, content.pictures[std::size_t(step)], cell(row, step), palette());
  if (content.note.isEmpty()) return;
  painter.setPen(palette().color(QPalette::WindowText));
  const QRectF note(labelWidth() + sphereGap, area.top(), area.width() - labelWidth() - 2 * sphereGap, area.height());
  const int lines = std::max(1, int(note.height() / fontMetrics().lineSpacing()));
  const QString fitting = fontMetrics().elidedText(content.note, Qt::ElideRight, int(note.width()) * lines);
  painter.drawText(note, Qt::AlignCenter | Qt::TextWordWrap, fitting);
}

void BlendStrip::drawSteps(QPainter& painter) const {
  painter.setPen(palette().color(QPalette::PlaceholderText));
  const double line = fontMetrics().height();
  for (int step = 0; step < m_steps.size(); ++step) {
    const QRectF column = cell(0, step);
    painter.drawText(QRectF(column.left() - sphereGap, 0, column.width() + 2 * sphereGap, line), Qt::AlignCenter,
                     m_steps[step]);
  }
  if (m_mark < 0 || m_steps.size() < 2) return;
  const double first = cell(0, 0).center().x(), last = cell(0, int(m_steps.size()) - 1).center().x();
  const double x = first + m_mark * (last - first), tip = headerHeight() - 1, size = 0.35 * line;
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(QPalette::Highlight));
  painter.drawPolygon(QPolygonF{{x, tip}, {x - size, tip - size}, {x + size, tip - size}});
}

void BlendStrip::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  if (m_rows.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const int inset = fontMetrics().height();
    painter.drawText(rect().adjusted(inset, 0, -inset, 0), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
    return;
  }
  const QRectF asked = event->rect();
  if (asked.top() < headerHeight()) drawSteps(painter);
  for (int row = 0; row < int(m_rows.size()); ++row)
    if (asked.intersects(rowArea(row))) drawRow(painter, row);
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(cell(m_cursor.row, m_cursor.step), 4, 4);
}

}  // namespace gonio::widgets

#include "moc_blend_strip.cpp"
