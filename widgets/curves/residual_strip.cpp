// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/curves/residual_strip.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "widgets/curves/curve_editor.h"

namespace gonio::widgets {

namespace {

QString percentText(double fraction) {
  const double value = 100 * fraction;
  const int decimals = value >= 10 || value == std::round(value) ? 0 : value >= 1 ? 1 : 2;
  return ResidualStrip::tr("%1 %").arg(value, 0, 'f', decimals);
}

}  // namespace

ResidualStrip::ResidualStrip(const CurveEditor& editor, QWidget* parent) : QWidget(parent), m_editor(editor) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Residual"));
  setToolTip(
      tr("Residual of the unedited curves at each position of the curve above, as a fraction of the transformed BRDF "
         "value there,\nwith the weights of the factorisation. More terms lower it. With \"Preserve measured detail\", "
         "the residual remains part of the material."));
}

QSize ResidualStrip::sizeHint() const { return {200, int(2.9 * fontMetrics().height())}; }

void ResidualStrip::setFractions(const std::vector<double>& fractions, const QString& title) {
  if (fractions == m_fractions && title == m_title) return;
  m_fractions = fractions;
  m_title = title;
  const auto largest = std::max_element(fractions.begin(), fractions.end());
  setAccessibleDescription(
      fractions.empty() ? QString()
                        : tr("%1: at most %2, at %3")
                              .arg(title, percentText(*largest),
                                   m_editor.axis().place(m_editor.nodes()[std::size_t(largest - fractions.begin())])));
  update();
}

double ResidualStrip::scale() const {
  const double largest = m_fractions.empty() ? 0 : *std::max_element(m_fractions.begin(), m_fractions.end());
  for (const double round : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5})
    if (largest <= round) return round;
  return 1;
}

void ResidualStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const PlotStyle style = PlotStyle::of(palette());
  painter.fillRect(rect(), style.background);
  const std::vector<double>& nodes = m_editor.nodes();
  if (m_fractions.empty() || m_fractions.size() != nodes.size()) return;
  const double line = fontMetrics().height(), top = line, bottom = height() - 3;
  const double left = m_editor.toX(0), right = m_editor.toX(nodes.back());
  QPainterPath area(QPointF(left, bottom));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    area.lineTo(m_editor.toX(nodes[i]), bottom - (bottom - top) * std::min(1.0, m_fractions[i] / scale()));
  area.lineTo(right, bottom);
  QColor fill = style.accent;
  fill.setAlphaF(0.35f);
  painter.setPen(QPen(style.accent, 1.2));
  painter.setBrush(fill);
  painter.drawPath(area);
  painter.setPen(style.gridPen());
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(left, top, right - left, bottom - top));
  painter.setPen(style.text);
  painter.drawText(QRectF(0, top - line / 3, left - 4, line), Qt::AlignRight, percentText(scale()));
  painter.drawText(QRectF(0, bottom - line + 3, left - 4, line), Qt::AlignRight, QStringLiteral("0"));
  painter.drawText(QRectF(left, 0, right - left, line), Qt::AlignLeft, m_title);
}

}  // namespace gonio::widgets

#include "moc_residual_strip.cpp"
