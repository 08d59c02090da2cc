// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/charts/custom_plot_style.h"

#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

#include "core/plots/value_scale.h"

namespace gonio::widgets {

QLabel* addHint(QWidget& widget, QCustomPlot& chart) {
  auto* layout = new QVBoxLayout(&widget);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(&chart);
  chart.axisRect()->setupFullAxesBox(true);
  auto* hint = new QLabel(&chart);
  hint->setAlignment(Qt::AlignCenter);
  hint->setWordWrap(true);
  hint->setForegroundRole(QPalette::PlaceholderText);
  hint->setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* over = new QVBoxLayout(&chart);
  over->setContentsMargins(60, 10, 20, 50);
  over->addWidget(hint);
  return hint;
}

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

namespace {

using GraphData = QSharedPointer<QCPGraphDataContainer>;

/// The graph's data where it lies between the ends of its axes.
GraphData cutData(const QCPGraph& graph) {
  const QCPRange keys = graph.keyAxis()->range(), values = graph.valueAxis()->range();
  const bool logarithmic = graph.valueAxis()->scaleType() == QCPAxis::stLogarithmic;
  const auto toAxis = [logarithmic](double value) { return logarithmic ? std::log(value) : value; };
  std::vector<glm::dvec2> points;
  for (const QCPGraphData& point : *graph.data()) points.emplace_back(point.key, toAxis(point.value));
  auto result = GraphData::create();
  for (const auto& part :
       plots::clipPolyline(points, {keys.lower, toAxis(values.lower)}, {keys.upper, toAxis(values.upper)})) {
    for (const glm::dvec2& point : part) result->add(QCPGraphData(point.x, logarithmic ? std::exp(point.y) : point.y));
    result->add(QCPGraphData(part.back().x, std::nan("")));
  }
  return result;
}

}  // namespace

void paintChart(QCustomPlot& chart, QPaintDevice& device, const QSize& size) {
  QList<GraphData> whole;
  for (int i = 0; i < chart.graphCount(); ++i) {
    whole << chart.graph(i)->data();
    chart.graph(i)->setData(cutData(*chart.graph(i)));
  }
  QCPPainter painter;
  painter.begin(&device);
  painter.setMode(QCPPainter::pmVectorized);
  painter.setMode(QCPPainter::pmNoCaching);
  chart.toPainter(&painter, size.width(), size.height());
  for (int i = 0; i < chart.graphCount(); ++i) chart.graph(i)->setData(whole[i]);
}

}  // namespace gonio::widgets
