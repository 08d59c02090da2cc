// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/acquisition/sample_chart.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/charts/plot_style.h"
#include "widgets/inputs/number_field.h"

namespace gonio::widgets {

namespace {
/// How near the pointer has to be, px.
constexpr double chartReach = 12;
/// Radius of a dot, px.
constexpr double sampleRadius = 4.5;
}  // namespace

QString sampleText(int number, const DirectionPair& directions) {
  const HalfDifference at = toHalfDifference(directions.wi, directions.wo);
  const auto angle = [](double value) { return degreesText(value); };
  return SampleChart::tr("%1: light θi %2, φi %3 · viewer θo %4, φo %5 · θh %6, θd %7, φd %8")
      .arg(number)
      .arg(angle(polarAngle(directions.wi)), angle(azimuth(directions.wi)), angle(polarAngle(directions.wo)),
           angle(azimuth(directions.wo)), angle(at.thetaH), angle(at.thetaD), angle(foldPhiD(at.phiD)));
}

SampleChart::SampleChart(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
}

QSize SampleChart::minimumSizeHint() const { return QSize(13, 13) * fontMetrics().height(); }

void SampleChart::setSamples(std::vector<DirectionPair> samples) {
  m_samples = std::move(samples);
  if (m_current >= int(m_samples.size())) m_current = -1;
  update();
}

void SampleChart::setCurrent(int sample) {
  if (sample == m_current || sample >= int(m_samples.size())) return;
  m_current = sample;
  update();
}

void SampleChart::setHint(const QString& hint) {
  m_hint = hint;
  update();
}

int SampleChart::sampleAt(const QPointF& place) const {
  int found = -1;
  double least = chartReach;
  for (int i = 0; i < int(m_samples.size()); ++i)
    for (const QPointF& dot : places(i)) {
      const double distance = std::hypot(dot.x() - place.x(), dot.y() - place.y());
      if (distance < least) {
        least = distance;
        found = i;
      }
    }
  return found;
}

QString SampleChart::toolTipOf(int sample) const {
  return sampleText(sample + 1, m_samples[std::size_t(sample)]).replace(QStringLiteral(" · "), QStringLiteral("\n"));
}

void SampleChart::drawCentred(QPainter& painter, const QPointF& at, const QString& text) {
  const QSizeF size = painter.fontMetrics().size(Qt::TextSingleLine, text);
  painter.drawText(QRectF(at - QPointF(size.width(), size.height()) / 2, size), Qt::AlignCenter, text);
}

void SampleChart::drawNumber(QPainter& painter, int sample, std::vector<QRectF>& taken) const {
  const bool marked = sample == m_current;
  const QString text = QString::number(sample + 1);
  const QSizeF size(fontMetrics().horizontalAdvance(text) + 3, 0.85 * fontMetrics().height());
  const QPointF dot = places(sample).front();
  constexpr double away = sampleRadius + 2;
  const QPointF corners[] = {{away, -size.height() / 2},
                             {-away - size.width(), -size.height() / 2},
                             {-size.width() / 2, -away - size.height()},
                             {-size.width() / 2, away}};
  for (const QPointF& corner : corners) {
    const QRectF box(dot + corner, size);
    if (!marked && std::ranges::any_of(taken, [&](const QRectF& one) { return one.intersects(box); })) continue;
    taken.push_back(box);
    QColor paper = palette().color(QPalette::Base);
    paper.setAlpha(190);
    painter.fillRect(box, paper);
    painter.setPen(palette().color(marked ? QPalette::Highlight : QPalette::Text));
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
    return;
  }
}

void SampleChart::drawNumbers(QPainter& painter, std::vector<QRectF> taken) const {
  for (int i = 0; i < int(m_samples.size()); ++i)
    for (const QPointF& dot : places(i))
      taken.emplace_back(dot - QPointF(sampleRadius, sampleRadius), QSizeF(2 * sampleRadius, 2 * sampleRadius));
  if (m_current >= 0) drawNumber(painter, m_current, taken);
  for (int i = 0; i < int(m_samples.size()); ++i)
    if (i != m_current) drawNumber(painter, i, taken);
}

void SampleChart::drawHint(QPainter& painter, const QRectF& within) const {
  if (!m_samples.empty() || m_hint.isEmpty()) return;
  const double margin = fontMetrics().height();
  const QRectF room = within.adjusted(margin, 0, -margin, 0);
  const QRectF text = painter.boundingRect(room, Qt::AlignCenter | Qt::TextWordWrap, m_hint);
  QColor paper = palette().color(QPalette::Base);
  paper.setAlpha(220);
  painter.setPen(Qt::NoPen);
  painter.setBrush(paper);
  painter.drawRoundedRect(text.adjusted(-margin / 2, -margin / 2, margin / 2, margin / 2), 4, 4);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(room, Qt::AlignCenter | Qt::TextWordWrap, m_hint);
}

void SampleChart::drawFocus(QPainter& painter) const {
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void SampleChart::moveTo(int sample) {
  if (sample == m_current) return;
  setCurrent(sample);
  Q_EMIT currentChanged(m_current);
}

bool SampleChart::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const int sample = sampleAt(help->pos());
  if (sample < 0) return QWidget::event(event);
  QToolTip::showText(help->globalPos(), toolTipOf(sample), this);
  return true;
}

void SampleChart::mouseMoveEvent(QMouseEvent* event) {
  const int sample = sampleAt(event->position());
  setCursor(sample >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (sample >= 0) moveTo(sample);
}

void SampleChart::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  const int sample = sampleAt(event->position());
  moveTo(sample);
  if (sample >= 0) Q_EMIT chosen(sample);
}

void SampleChart::leaveEvent(QEvent*) { setCursor(Qt::ArrowCursor); }

void SampleChart::keyPressEvent(QKeyEvent* event) {
  const int last = int(m_samples.size()) - 1;
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
      return moveTo(std::min(last, std::max(0, m_current - 1)));
    case Qt::Key_Right:
    case Qt::Key_Up:
      return moveTo(std::min(last, m_current + 1));
    case Qt::Key_Home:
      return moveTo(std::min(last, 0));
    case Qt::Key_End:
      return moveTo(last);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (m_current >= 0) Q_EMIT chosen(m_current);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void SampleChart::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void SampleChart::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

}  // namespace gonio::widgets

#include "moc_sample_chart.cpp"
