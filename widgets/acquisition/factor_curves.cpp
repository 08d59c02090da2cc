// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/acquisition/factor_curves.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/charts/custom_plot_style.h"

namespace gonio::widgets {

namespace {

constexpr double readingSize = 3.5;

QCustomPlot* newChart(QWidget* parent, const char* name) {
  auto* chart = new QCustomPlot(parent);
  chart->setObjectName(QString::fromLatin1(name));
  chart->axisRect()->setupFullAxesBox(true);
  for (QCPAxis* axis : {chart->xAxis2, chart->yAxis2}) axis->setTicks(false);
  return chart;
}

}  // namespace

FactorCurves::FactorCurves(QWidget* parent)
    : QWidget(parent), m_along(newChart(this, "along")), m_across(newChart(this, "across")), m_hint(new QLabel) {
  m_along->setAccessibleName(tr("Readings in the mirror direction"));
  m_across->setAccessibleName(tr("Readings around the mirror direction"));
  m_along->setToolTip(tr("Readings in the mirror direction, vs. the angle"));
  m_across->setToolTip(
      tr("Readings around the mirror direction at the fixed angle, relative to the reading in the mirror direction"));
  m_hint->setAlignment(Qt::AlignCenter);
  m_hint->setWordWrap(true);
  m_hint->setForegroundRole(QPalette::PlaceholderText);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  for (QWidget* part : std::initializer_list<QWidget*>{m_along, m_across, m_hint}) layout->addWidget(part, 1);
  refresh();
}

QSize FactorCurves::sizeHint() const { return QSize(24, 24) * fontMetrics().height(); }
QSize FactorCurves::minimumSizeHint() const { return QSize(13, 14) * fontMetrics().height(); }

void FactorCurves::setContent(Content content) {
  m_content = std::move(content);
  refresh();
}

void FactorCurves::setHint(const QString& hint) { m_hint->setText(hint); }

void FactorCurves::refresh() {
  const PlotStyle style = PlotStyle::of(palette());
  const bool isEmpty = m_content.angles.empty();
  for (QCustomPlot* chart : {m_along, m_across}) chart->setVisible(!isEmpty);
  m_hint->setVisible(isEmpty);
  draw(*m_along, m_content.angles, m_content.along, style);
  draw(*m_across, m_content.distances, m_content.across, style);
  m_along->xAxis->setLabel(tr("%1, in the mirror direction").arg(m_content.angleTitle));
  m_along->yAxis->setLabel(tr("ln(1 + ρ)"));
  m_across->xAxis->setLabel(tr("%1, from the mirror direction").arg(m_content.distanceTitle));
  m_across->yAxis->setLabel(tr("ln(1 + ρ), relative"));
  for (QCustomPlot* chart : {m_along, m_across}) chart->replot(QCustomPlot::rpQueuedReplot);
}

void FactorCurves::draw(QCustomPlot& chart, const std::vector<double>& places, const Channels& curves,
                        const PlotStyle& style) const {
  chart.clearGraphs();
  styleChart(chart, style, font());
  double highest = 0;
  for (std::size_t channel = 0; channel < curves.size(); ++channel) {
    const QPen pen = style.channelPen(int(channel));
    QCPGraph* graph = chart.addGraph();
    graph->setPen(pen);
    graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, pen.color(), pen.color(), readingSize));
    for (std::size_t i = 0; i < std::min(places.size(), curves[channel].size()); ++i) {
      graph->addData(places[i], curves[channel][i]);
      highest = std::max(highest, curves[channel][i]);
    }
  }
  chart.xAxis->setRange(0, places.empty() ? 1 : places.back());
  chart.yAxis->setRange(0, highest > 0 ? 1.06 * highest : 1);
}

void FactorCurves::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) refresh();
}

}  // namespace gonio::widgets

#include "moc_factor_curves.cpp"
