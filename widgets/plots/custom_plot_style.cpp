// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/plots/custom_plot_style.h"

#include "widgets/plots/custom_plot.h"

namespace gonio::widgets {

void styleAxis(QCPAxis& axis, const PlotStyle& style, const QFont& font) {
  axis.setBasePen(QPen(style.text, 1));
  axis.setTickPen(QPen(style.text, 1));
  axis.setSubTickPen(QPen(style.text, 1));
  axis.setTickLabelColor(style.text);
  axis.setLabelColor(style.text);
  axis.setTickLabelFont(font);
  axis.setLabelFont(font);
  axis.grid()->setPen(style.gridPen());
  axis.grid()->setZeroLinePen(style.gridPen());
}

void styleChart(QCustomPlot& chart, const PlotStyle& style, const QFont& font) {
  chart.setBackground(QBrush(style.background));
  for (QCPAxisRect* rect : chart.axisRects())
    for (QCPAxis* axis : rect->axes()) styleAxis(*axis, style, font);
  if (!chart.legend) return;
  chart.legend->setFont(font);
  chart.legend->setTextColor(style.text);
  chart.legend->setBorderPen(Qt::NoPen);
  QColor behind = style.background;
  behind.setAlpha(200);
  chart.legend->setBrush(behind);
  chart.legend->setIconSize(QFontMetrics(font).height() * 5 / 2, QFontMetrics(font).height());
}

void setLogarithmic(QCPAxis& axis, bool logarithmic) {
  if ((axis.scaleType() == QCPAxis::stLogarithmic) == logarithmic) return;
  axis.setScaleType(logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
  if (logarithmic) {
    axis.setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    axis.setNumberFormat(QStringLiteral("eb"));
    axis.setNumberPrecision(0);
  } else {
    axis.setTicker(QSharedPointer<QCPAxisTicker>::create());
    axis.setNumberFormat(QStringLiteral("gb"));
    axis.setNumberPrecision(6);
  }
}

void paintChart(QCustomPlot& chart, QPaintDevice& device, const QSize& size) {
  QCPPainter painter;
  painter.begin(&device);
  painter.setMode(QCPPainter::pmVectorized);
  painter.setMode(QCPPainter::pmNoCaching);
  chart.toPainter(&painter, size.width(), size.height());
}

}  // namespace gonio::widgets
