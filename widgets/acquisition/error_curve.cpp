// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/acquisition/error_curve.h"

#include <QHelpEvent>
#include <QLabel>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/charts/custom_plot_style.h"
#include "widgets/inputs/number_field.h"

namespace gonio::widgets {

namespace {
constexpr double markerSize = 7, ringSize = 15;
/// How near the pointer has to be, px.
constexpr double hoverReach = 12;
}  // namespace

ErrorCurve::ErrorCurve(QWidget* parent)
    : QWidget(parent), m_chart(new QCustomPlot(this)), m_hint(addHint(*this, *m_chart)) {
  setAccessibleName(tr("Error vs. number of samples"));
  m_chart->setObjectName(QStringLiteral("chart"));
  m_chart->installEventFilter(this);
  refresh();
}

QSize ErrorCurve::sizeHint() const { return QSize(24, 18) * fontMetrics().height(); }
QSize ErrorCurve::minimumSizeHint() const { return QSize(13, 9) * fontMetrics().height(); }

void ErrorCurve::setPoints(std::vector<Point> points, const QString& title, bool logarithmic) {
  m_points = std::move(points);
  std::ranges::sort(m_points, {}, &Point::samples);
  m_title = title;
  m_logarithmic = logarithmic;
  refresh();
}

void ErrorCurve::setMarked(int samples) {
  m_marked = samples;
  refresh();
}

void ErrorCurve::setHint(const QString& hint) { m_hint->setText(hint); }

std::optional<QPointF> ErrorCurve::place(int point) const {
  if (point < 0 || point >= int(m_points.size())) return std::nullopt;
  const Point& one = m_points[std::size_t(point)];
  if (!std::isfinite(one.value) || (m_logarithmic && one.value <= 0)) return std::nullopt;
  return QPointF(m_chart->xAxis->coordToPixel(one.samples), m_chart->yAxis->coordToPixel(one.value));
}

int ErrorCurve::pointAt(const QPointF& at) const {
  int found = -1;
  double least = hoverReach;
  for (int i = 0; i < int(m_points.size()); ++i)
    if (const auto dot = place(i); dot && std::hypot(dot->x() - at.x(), dot->y() - at.y()) < least) {
      least = std::hypot(dot->x() - at.x(), dot->y() - at.y());
      found = i;
    }
  return found;
}

void ErrorCurve::refresh() {
  const PlotStyle style = PlotStyle::of(palette());
  m_chart->clearPlottables();
  addAxes(style);
  addPoints(style);
  m_hint->setVisible(m_points.empty());
  m_chart->replot(QCustomPlot::rpQueuedReplot);
}

void ErrorCurve::addAxes(const PlotStyle& style) {
  styleChart(*m_chart, style, font());
  setLogarithmic(*m_chart->yAxis, m_logarithmic);
  m_chart->xAxis->setLabel(tr("Number of samples"));
  m_chart->yAxis->setLabel(m_title);
  for (QCPAxis* axis : {m_chart->xAxis2, m_chart->yAxis2}) axis->setTicks(false);
  int most = std::max(10, m_marked);
  double lowest = INFINITY, highest = -INFINITY;
  for (int i = 0; i < int(m_points.size()); ++i) {
    if (!place(i)) continue;
    most = std::max(most, m_points[std::size_t(i)].samples);
    lowest = std::min(lowest, m_points[std::size_t(i)].value);
    highest = std::max(highest, m_points[std::size_t(i)].value);
  }
  m_chart->xAxis->setRange(0, most * 1.04);
  if (lowest > highest) {
    m_chart->yAxis->setRange(m_logarithmic ? 0.01 : 0, m_logarithmic ? 1 : 50);
  } else if (m_logarithmic) {
    m_chart->yAxis->setRange(lowest / 1.5, highest * 1.5);
  } else {
    const double room = std::max(1.0, 0.1 * (highest - lowest));
    m_chart->yAxis->setRange(lowest - room, highest + room);
  }
}

void ErrorCurve::addPoints(const PlotStyle& style) {
  const auto graph = [this](const QPen& pen, const QCPScatterStyle& dots) {
    QCPGraph* one = m_chart->addGraph();
    one->setPen(pen);
    one->setScatterStyle(dots);
    return one;
  };
  const QColor colour = style.colour(SeriesRole::fit);
  QCPGraph* line = graph(QPen(colour, 1.8), QCPScatterStyle(QCPScatterStyle::ssDisc, colour, colour, markerSize));
  QCPGraph* ring = graph(
      Qt::NoPen, QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(style.accent, 2), QBrush(Qt::NoBrush), ringSize));
  for (int i = 0; i < int(m_points.size()); ++i) {
    if (!place(i)) continue;
    const Point& one = m_points[std::size_t(i)];
    line->addData(one.samples, one.value);
    if (one.samples == m_marked) ring->addData(one.samples, one.value);
  }
}

void ErrorCurve::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) refresh();
}

bool ErrorCurve::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_chart || event->type() != QEvent::ToolTip) return QWidget::eventFilter(watched, event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const int point = pointAt(help->pos());
  if (point < 0) return false;
  const Point& one = m_points[std::size_t(point)];
  QToolTip::showText(
      help->globalPos(),
      tr("Samples: %n\n", nullptr, one.samples) + QStringLiteral("%1: %2").arg(m_title, formatNumber(one.value)), this);
  return true;
}

}  // namespace gonio::widgets

#include "moc_error_curve.cpp"
