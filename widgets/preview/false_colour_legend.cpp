// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/false_colour_legend.h"

#include <QPainter>

#include "core/rendering/error_maps.h"

namespace gonio::widgets {

namespace {
constexpr int margin = 8, barHeight = 10, gap = 4;
constexpr QColor paper(0, 0, 0, 150), ink(232, 232, 232);
}  // namespace

void drawColourBar(QPainter& painter, const QRect& bar, DifferenceKind kind) {
  for (int x = 0; x < bar.width(); ++x) {
    const double fraction = x / std::max(1.0, bar.width() - 1.0);
    const rendering::DisplayColour colour =
        kind == DifferenceKind::signedValue ? rendering::signedColour(2 * fraction - 1) : rendering::viridis(fraction);
    painter.fillRect(bar.left() + x, bar.top(), 1, bar.height(), QColor(colour[0], colour[1], colour[2]));
  }
}

FalseColourLegend::FalseColourLegend(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setDifference(DifferenceKind::absolute, 1);
}

void FalseColourLegend::setDifference(DifferenceKind kind, double range) {
  m_kind = kind;
  m_range = range;
  setAccessibleName(tr("%1; scale maximum: %2").arg(differenceTitle(kind), differenceNumber(kind, range)));
  update();
}

QSize FalseColourLegend::sizeHint() const {
  const QFontMetrics metrics = fontMetrics();
  return {metrics.horizontalAdvance(differenceTitle(DifferenceKind::absolute)) + 2 * margin + gap,
          2 * metrics.height() + barHeight + 2 * gap + 2 * margin};
}

void FalseColourLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(paper);
  painter.drawRoundedRect(rect(), 4, 4);
  const QRect inner = rect().adjusted(margin, margin, -margin, -margin);
  const int line = fontMetrics().height();
  painter.setPen(ink);
  painter.drawText(QRect(inner.left(), inner.top(), inner.width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                   fontMetrics().elidedText(differenceTitle(m_kind), Qt::ElideRight, inner.width()));
  const QRect bar(inner.left(), inner.top() + line + gap, inner.width(), barHeight);
  const bool isSigned = m_kind == DifferenceKind::signedValue;
  painter.setRenderHint(QPainter::Antialiasing, false);
  drawColourBar(painter, bar, m_kind);
  const QRect numbers(inner.left(), bar.bottom() + 1 + gap, inner.width(), line);
  const double first = isSigned ? -m_range : 0;
  painter.drawText(numbers, Qt::AlignLeft,
                   (isSigned ? tr("≤ %1") : QStringLiteral("%1")).arg(differenceNumber(m_kind, first)));
  painter.drawText(numbers, Qt::AlignHCenter, differenceNumber(m_kind, 0.5 * (first + m_range)));
  painter.drawText(numbers, Qt::AlignRight, tr("≥ %1").arg(differenceNumber(m_kind, m_range)));
}

}  // namespace gonio::widgets

#include "moc_false_colour_legend.cpp"
