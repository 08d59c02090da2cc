// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/acquisition/uncertainty_curve.h"

#include <QHelpEvent>
#include <QLabel>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/charts/custom_plot_style.h"
#include "widgets/inputs/number_field.h"

namespace gonio::widgets {

namespace {
/// Half angles have the spacing of MERL tables, dense at the highlight, as in HalfDifferenceChart.
double uncertaintyPlace(double thetaH) { return std::sqrt(thetaH / 90); }
constexpr int markedAngles[] = {0, 1, 5, 10, 20, 30, 45, 60, 90};
}  // namespace

UncertaintyCurve::UncertaintyCurve(QWidget* parent)
    : QWidget(parent), m_chart(new QCustomPlot(this)), m_hint(addHint(*this, *m_chart)) {
  setAccessibleName(tr("Uncertainty vs. half angle"));
  setToolTip(tr(
      "Standard deviation of the mapped value, nearly the logarithm of the BRDF value, given the photographs: 0.1 is "
      "about 10 %, except in dark cells.\n"
      "The line is the median over all cells of a half angle, the band contains 80 % of them."));
  m_chart->installEventFilter(this);
  refresh();
}

QSize UncertaintyCurve::sizeHint() const { return QSize(20, 11) * fontMetrics().height(); }
QSize UncertaintyCurve::minimumSizeHint() const { return QSize(12, 7) * fontMetrics().height(); }

void UncertaintyCurve::setPoints(std::vector<Point> points) {
  m_points = std::move(points);
  refresh();
}

void UncertaintyCurve::setHint(const QString& hint) { m_hint->setText(hint); }

void UncertaintyCurve::refresh() {
  const PlotStyle style = PlotStyle::of(palette());
  m_chart->clearPlottables();
  styleChart(*m_chart, style, font());
  m_chart->xAxis->setLabel(tr("Half angle θh [°]"));
  m_chart->yAxis->setLabel(tr("Standard deviation"));
  for (QCPAxis* axis : {m_chart->xAxis2, m_chart->yAxis2}) axis->setTicks(false);
  m_chart->xAxis->setRange(uncertaintyPlace(0), uncertaintyPlace(90));
  const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
  for (const int angle : markedAngles) ticker->addTick(uncertaintyPlace(angle), QString::number(angle));
  m_chart->xAxis->setTicker(ticker);
  double highest = 0;
  for (const Point& point : m_points) highest = std::max(highest, point.high);
  m_chart->yAxis->setRange(0, highest > 0 ? 1.08 * highest : 1);
  addBand(style);
  m_hint->setVisible(m_points.empty());
  m_chart->replot(QCustomPlot::rpQueuedReplot);
}

void UncertaintyCurve::addBand(const PlotStyle& style) {
  const QColor colour = style.colour(SeriesRole::fit);
  QColor fill = colour;
  fill.setAlphaF(0.25f);
  QCPGraph *low = m_chart->addGraph(), *high = m_chart->addGraph(), *median = m_chart->addGraph();
  for (QCPGraph* edge : {low, high}) edge->setPen(Qt::NoPen);
  high->setBrush(fill);
  high->setChannelFillGraph(low);
  median->setPen(QPen(colour, 1.8));
  for (const Point& point : m_points) {
    const double place = uncertaintyPlace(point.thetaH);
    low->addData(place, point.low);
    high->addData(place, point.high);
    median->addData(place, point.median);
  }
}

void UncertaintyCurve::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) refresh();
}

bool UncertaintyCurve::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_chart || event->type() != QEvent::ToolTip || m_points.empty())
    return QWidget::eventFilter(watched, event);
  const auto* help = static_cast<QHelpEvent*>(event);
  if (!m_chart->axisRect()->rect().contains(help->pos())) return QWidget::eventFilter(watched, event);
  const double place = m_chart->xAxis->pixelToCoord(help->pos().x());
  const Point& nearest = *std::ranges::min_element(
      m_points, {}, [place](const Point& one) { return std::abs(uncertaintyPlace(one.thetaH) - place); });
  QToolTip::showText(help->globalPos(),
                     tr("θh %1°: standard deviation %2 (80 % of the cells: %3 to %4)")
                             .arg(formatNumber(nearest.thetaH), formatNumber(nearest.median), formatNumber(nearest.low),
                                  formatNumber(nearest.high)) +
                         '\n' + toolTip(),
                     this);
  return true;
}

}  // namespace gonio::widgets

#include "moc_uncertainty_curve.cpp"
