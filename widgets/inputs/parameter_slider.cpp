// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/parameter_slider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace gonio::widgets {

namespace {
constexpr int accessibleSteps = 1000;
constexpr double keyFraction = 0.01, pageFraction = 0.1, fineFactor = 0.1;
constexpr double snapSteps = 20;
constexpr int wheelPauseMilliseconds = 400;
}  // namespace

ParameterSlider::ParameterSlider(QWidget* parent) : QAbstractSlider(parent), m_wheelPause(new QTimer(this)) {
  setOrientation(Qt::Horizontal);
  QAbstractSlider::setRange(0, accessibleSteps);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  m_wheelPause->setSingleShot(true);
  m_wheelPause->setInterval(wheelPauseMilliseconds);
  connect(m_wheelPause, &QTimer::timeout, this, &ParameterSlider::end);
}

void ParameterSlider::setRange(double softMin, double softMax, models::ParameterScale scale) {
  m_min = softMin;
  m_max = softMax;
  m_scale = scale == models::ParameterScale::logarithmic && softMin <= 0 ? models::ParameterScale::linear : scale;
  syncAccessibleValue();
  update();
}

void ParameterSlider::setNumber(double value) {
  m_number = value;
  syncAccessibleValue();
  update();
}

void ParameterSlider::setReference(std::optional<double> value) {
  m_reference = value;
  update();
}

void ParameterSlider::setModified(bool modified) {
  m_modified = modified;
  update();
}

/// Screen readers see the position in thousandths; the number itself is kept in full precision.
void ParameterSlider::syncAccessibleValue() { setValue(int(std::lround(fractionOf(m_number) * accessibleSteps))); }

double ParameterSlider::fractionOf(double value) const {
  if (!(m_max > m_min)) return 0;
  if (m_scale == models::ParameterScale::logarithmic)
    return value <= m_min ? 0 : std::clamp(std::log(value / m_min) / std::log(m_max / m_min), 0.0, 1.0);
  const double fraction = std::clamp((value - m_min) / (m_max - m_min), 0.0, 1.0);
  return m_scale == models::ParameterScale::lightness ? std::cbrt(fraction) : fraction;
}

double ParameterSlider::valueAt(double fraction) const {
  // The ends exactly, so that the slider reaches its limits bit by bit.
  if (fraction <= 0) return m_min;
  if (fraction >= 1) return m_max;
  if (m_scale == models::ParameterScale::logarithmic) return m_min * std::pow(m_max / m_min, fraction);
  const double spread = m_scale == models::ParameterScale::lightness ? fraction * fraction * fraction : fraction;
  return m_min + spread * (m_max - m_min);
}

double ParameterSlider::snapped(double fraction) const { return std::round(fraction * snapSteps) / snapSteps; }

void ParameterSlider::begin() {
  if (m_editing) return;
  m_editing = true;
  Q_EMIT editingStarted();
}

void ParameterSlider::end() {
  m_wheelPause->stop();
  if (!m_editing) return;
  m_editing = false;
  Q_EMIT editingFinished();
}

void ParameterSlider::editTo(double fraction, bool snap) {
  double value = valueAt(snap ? snapped(fraction) : fraction);
  // Under the pointer, a value that reads as the reference is the reference: the slider would be marked as changed at
  // "1" otherwise.
  constexpr double halfPixel = 0.5;
  if (m_dragging && m_reference && std::abs(fraction - fractionOf(*m_reference)) * groove().width() < halfPixel)
    value = *m_reference;
  if (value == m_number) return;
  setNumber(value);
  Q_EMIT numberEdited(value);
}

QSize ParameterSlider::sizeHint() const { return {fontMetrics().height() * 8, minimumSizeHint().height()}; }
QSize ParameterSlider::minimumSizeHint() const {
  return {fontMetrics().height() * 4, std::max(fontMetrics().height() + 6, 2 * handleRadius() + 6)};
}

int ParameterSlider::handleRadius() const { return std::max(5, fontMetrics().height() * 3 / 8); }

QRectF ParameterSlider::groove() const {
  const double radius = handleRadius() + 2;
  return {radius, height() / 2.0 - 2, width() - 2 * radius, 4};
}

void ParameterSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPalette& colours = palette();
  const QRectF track = groove();
  const double x = track.left() + fractionOf(m_number) * track.width();
  const QColor text = isEnabled() ? colours.color(QPalette::Text) : colours.color(QPalette::Disabled, QPalette::Text);

  painter.setPen(Qt::NoPen);
  QColor rest = text;
  rest.setAlphaF(0.22f);
  painter.setBrush(rest);
  painter.drawRoundedRect(track, 2, 2);
  QColor filled = m_modified ? colours.color(QPalette::Highlight) : text;
  if (!m_modified) filled.setAlphaF(0.55f);
  painter.setBrush(filled);
  painter.drawRoundedRect(QRectF(track.left(), track.top(), x - track.left(), track.height()), 2, 2);

  if (m_reference && m_modified) {
    const double mark = track.left() + fractionOf(*m_reference) * track.width();
    painter.fillRect(QRectF(mark - 1, track.center().y() - 6, 2, 12), text);
  }
  const double radius = handleRadius() - (m_hovered || m_dragging ? 0 : 1);
  painter.setBrush(m_modified ? colours.color(QPalette::Highlight) : colours.color(QPalette::Light));
  painter.setPen(QPen(text, 1.25));
  painter.drawEllipse(QPointF(x, track.center().y()), radius, radius);
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.color(QPalette::Highlight), 2));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
  }
}

void ParameterSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  m_dragging = true;
  m_lastX = event->position().x();
  const bool fine = event->modifiers() & Qt::ShiftModifier;
  // A fine drag starts where the value is; a plain press jumps to the pointer, unless it holds the handle.
  const double under = (m_lastX - groove().left()) / groove().width();
  const double held = fractionOf(m_number);
  const bool onHandle = std::abs(under - held) * groove().width() <= handleRadius() + 1;
  m_dragFraction = fine || onHandle ? held : under;
  begin();
  if (!fine && !onHandle) editTo(m_dragFraction, event->modifiers() & Qt::ControlModifier);
  update();
}

void ParameterSlider::mouseMoveEvent(QMouseEvent* event) {
  if (!m_dragging) return;
  const bool fine = event->modifiers() & Qt::ShiftModifier;
  const double x = event->position().x();
  if (x == m_lastX) return;
  m_dragFraction += (x - m_lastX) / groove().width() * (fine ? fineFactor : 1);
  m_lastX = x;
  editTo(m_dragFraction, event->modifiers() & Qt::ControlModifier);
}

void ParameterSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !m_dragging) return;
  m_dragging = false;
  end();
  update();
}

void ParameterSlider::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) Q_EMIT resetRequested();
}

void ParameterSlider::keyPressEvent(QKeyEvent* event) {
  const double step = keyFraction * (event->modifiers() & Qt::ShiftModifier ? fineFactor : 1);
  double fraction = fractionOf(m_number);
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
      fraction -= step;
      break;
    case Qt::Key_Right:
    case Qt::Key_Up:
      fraction += step;
      break;
    case Qt::Key_PageDown:
      fraction -= pageFraction;
      break;
    case Qt::Key_PageUp:
      fraction += pageFraction;
      break;
    case Qt::Key_Home:
      fraction = 0;
      break;
    case Qt::Key_End:
      fraction = 1;
      break;
    case Qt::Key_Backspace:
      Q_EMIT resetRequested();
      return;
    default:
      return event->ignore();
  }
  begin();
  editTo(fraction, false);
}

void ParameterSlider::keyReleaseEvent(QKeyEvent* event) {
  if (event->isAutoRepeat() || m_dragging) return;
  end();
}

void ParameterSlider::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) return event->ignore();
  const int delta = event->angleDelta().y() ? event->angleDelta().y() : event->angleDelta().x();
  begin();
  editTo(fractionOf(m_number) + delta / 120.0 * keyFraction * (event->modifiers() & Qt::ShiftModifier ? fineFactor : 1),
         false);
  m_wheelPause->start();
  event->accept();
}

void ParameterSlider::focusOutEvent(QFocusEvent* event) {
  QAbstractSlider::focusOutEvent(event);
  if (!m_dragging) end();
}

bool ParameterSlider::event(QEvent* event) {
  if (event->type() == QEvent::Enter || event->type() == QEvent::Leave) {
    m_hovered = event->type() == QEvent::Enter;
    update();
  }
  return QAbstractSlider::event(event);
}

}  // namespace gonio::widgets

#include "moc_parameter_slider.cpp"
