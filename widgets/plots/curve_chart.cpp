// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/plots/curve_chart.h"

#include <QMouseEvent>
#include <QVBoxLayout>
#include <cmath>

#include "core/plots/value_scale.h"
#include "widgets/charts/custom_plot_style.h"
#include "widgets/inputs/number_field.h"
#include "widgets/plots/plot_series.h"

namespace gonio::widgets {

using plots::SectionAxis;

CartesianPlot::CartesianPlot(QWidget* parent) : CurveChart(tr("Cartesian"), parent) {
  setAccessibleDescription(tr("BRDF values vs. one angle; the other angles are fixed."));
}

void CartesianPlot::setSection(const plots::Section& section, PlotSeriesList<plots::Curve> series) {
  // Another axis is another view.
  const bool otherAxis = section.axis != m_section.axis;
  m_section = section;
  setSeries(std::move(series));
  if (otherAxis) resetView();
}

ChartAxes CartesianPlot::axes() const {
  const QString value = valueTitle(settings());
  const std::string comment = valueForCsv(settings());
  const auto fixed = [](const QString& name, double angle) {
    return QStringLiteral("%1 = %2").arg(name, degreesText(angle));
  };
  switch (m_section.axis) {
    case SectionAxis::thetaH:
      return {tr("θh [°], %1, %2").arg(fixed(tr("θd"), m_section.thetaD), fixed(tr("φd"), m_section.phiD)),
              value,
              0,
              90,
              "theta_h",
              "1/sr",
              tr("1/sr"),
              comment};
    case SectionAxis::thetaD:
      return {tr("θd [°], %1, %2").arg(fixed(tr("θh"), m_section.thetaH), fixed(tr("φd"), m_section.phiD)),
              value,
              0,
              90,
              "theta_d",
              "1/sr",
              tr("1/sr"),
              comment};
    case SectionAxis::thetaO:
      break;
  }
  const QString plane = m_section.planeAzimuth == 0
                            ? tr("in the plane of incidence")
                            : tr("%1 from the plane of incidence").arg(degreesText(m_section.planeAzimuth));
  return {tr("θo [°], %1, %2").arg(plane, fixed(tr("θi"), m_section.thetaI)),
          value,
          -90,
          90,
          "theta_o",
          "1/sr",
          tr("1/sr"),
          comment};
}

std::optional<double> CartesianPlot::incidence() const {
  switch (m_section.axis) {
    case SectionAxis::thetaH:
      return std::nullopt;
    case SectionAxis::thetaD:
      return degrees(settings().thetaI);
    case SectionAxis::thetaO:
      break;
  }
  return degrees(settings().thetaI);  // the mirror direction
}

std::vector<std::string> CartesianPlot::fixedForCsv() const {
  switch (m_section.axis) {
    case SectionAxis::thetaH:
      return {angleForCsv("theta_d", m_section.thetaD), angleForCsv("phi_d", m_section.phiD)};
    case SectionAxis::thetaD:
      return {angleForCsv("theta_h", m_section.thetaH), angleForCsv("phi_d", m_section.phiD)};
    case SectionAxis::thetaO:
      break;
  }
  return {angleForCsv("theta_i", m_section.thetaI),
          angleForCsv("azimuth of the viewer's plane from the plane of incidence", m_section.planeAzimuth),
          "theta_o > 0 lies on the side of the mirror direction"};
}

AlbedoPlot::AlbedoPlot(QWidget* parent) : CurveChart(tr("Albedo"), parent) {
  setAccessibleDescription(
      tr("Directional albedo vs. the polar angle of the viewer; above 1 a material gains energy."));
}

ChartAxes AlbedoPlot::axes() const {
  const QString channel = channelName(settings().channel).toLower();
  return {tr("Viewing angle θo [°]"),
          tr("Albedo, %1: ∫ ρ cos θi dωi").arg(channel),
          0,
          90,
          "theta_o",
          "1",
          QString(),
          "albedo, " + channelForCsv(settings().channel) +
              " (integral of rho cos theta_i over the directions of the light)"};
}

namespace {

void setVertical(QCPItemStraightLine* line, double x) {
  line->point1->setCoords(x, 1);
  line->point2->setCoords(x, 2);
}

}  // namespace

CurveChart::CurveChart(const QString& title, QWidget* parent) : Plot(title, parent), m_chart(new QCustomPlot(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_chart);
  m_chart->setFocusProxy(this);
  m_chart->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  m_chart->setMouseTracking(true);
  m_chart->installEventFilter(this);
  m_chart->legend->setVisible(true);
  m_chart->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignLeft | Qt::AlignTop);
  m_chart->axisRect()->setupFullAxesBox(true);
  m_chart->addLayer(QStringLiteral("marks"), m_chart->layer(QStringLiteral("main")), QCustomPlot::limAbove);
  m_chart->setCurrentLayer(QStringLiteral("marks"));
  m_line = new QCPItemStraightLine(m_chart);
  m_crosshair = new QCPItemStraightLine(m_chart);
  m_limit = new QCPItemStraightLine(m_chart);
  m_lineLabel = new QCPItemText(m_chart);
  m_lineLabel->position->setTypeX(QCPItemPosition::ptPlotCoords);
  m_lineLabel->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
  m_lineLabel->setPositionAlignment(Qt::AlignHCenter | Qt::AlignBottom);
  m_lineLabel->setClipToAxisRect(false);
  m_lineLabel->setPadding(QMargins(0, 0, 0, 3));
  m_crosshair->setVisible(false);
  m_chart->setCurrentLayer(QStringLiteral("main"));
}

void CurveChart::setSeries(PlotSeriesList<plots::Curve> series) {
  m_series = std::move(series);
  m_chart->setVisible(!isEmpty());
  showEmptiness();
  refresh();
}

void CurveChart::refresh() {
  fillGraphs();
  apply(style());
  applyScale();
  m_chart->replot(QCustomPlot::rpQueuedReplot);
}

void CurveChart::fillGraphs() {
  m_chart->clearGraphs();
  for (const auto& [role, name, curve] : m_series) {
    QCPGraph* graph = m_chart->addGraph();
    graph->setName(name);
    graph->setAdaptiveSampling(false);  // it would leave out the gaps of what is not known
    QVector<double> angles, values;
    for (std::size_t i = 0; i < curve.angles.size(); ++i) {
      const double value = curve.points.at(i, settings().channel);
      angles << degrees(curve.angles[i]);
      // A logarithmic axis has no place for 0.
      values << (settings().logarithmic && !(value > 0) ? std::nan("") : value);
    }
    graph->setData(angles, values, true);
  }
}

void CurveChart::apply(const PlotStyle& style) {
  const ChartAxes titles = axes();
  styleChart(*m_chart, style, font());
  m_chart->axisRect()->setMinimumMargins(QMargins(0, fontMetrics().height() * 3 / 2, fontMetrics().height(), 0));
  m_chart->xAxis->setLabel(titles.angleTitle);
  m_chart->yAxis->setLabel(settings().logarithmic ? tr("%1, logarithmic").arg(titles.valueTitle) : titles.valueTitle);
  const auto degreesTicker = QSharedPointer<QCPAxisTickerFixed>::create();
  degreesTicker->setTickStep(15);
  degreesTicker->setTickCount(12);
  degreesTicker->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
  if (!m_viewChanged) m_chart->xAxis->setTicker(degreesTicker);
  setLogarithmic(*m_chart->yAxis, settings().logarithmic);
  setLogarithmic(*m_chart->yAxis2, settings().logarithmic);
  for (int i = 0; i < m_chart->graphCount(); ++i) m_chart->graph(i)->setPen(style.pen(m_series[std::size_t(i)].role));
  m_line->setPen(style.accentPen());
  m_crosshair->setPen(QPen(style.text, 1, Qt::DashLine));
  m_limit->setPen(QPen(style.text, 1, Qt::DotLine));
  m_limit->setVisible(limit().has_value());
  if (limit()) {
    m_limit->point1->setCoords(0, *limit());
    m_limit->point2->setCoords(1, *limit());
  }
  const auto at = incidence();
  m_line->setVisible(at.has_value());
  m_lineLabel->setVisible(at.has_value());
  if (!at) return;
  setVertical(m_line, *at);
  m_lineLabel->setText(tr("θi %1").arg(degreesText(settings().thetaI)));
  m_lineLabel->position->setCoords(*at, 0);
  m_lineLabel->setColor(style.text);
  m_lineLabel->setFont(font());
}

void CurveChart::applyScale() {
  if (m_viewChanged) return;
  std::vector<double> values = shownValues(m_series, settings().channel);
  if (limit()) values.push_back(*limit());
  const plots::ValueScale scale = plots::scaleFor(values, settings().logarithmic);
  m_chart->xAxis->setRange(axes().first, axes().last);
  m_chart->yAxis->setRange(scale.min, scale.max);
}

void CurveChart::resetView() {
  m_viewChanged = false;
  refresh();
}

void CurveChart::drawOn(QPaintDevice& device, const QSize& size, const PlotStyle& paper) {
  m_crosshair->setVisible(false);
  apply(paper);
  paintChart(*m_chart, device, size);
  apply(style());
  m_chart->replot(QCustomPlot::rpQueuedReplot);
}

io::CsvTable CurveChart::table() const {
  const ChartAxes titles = axes();
  io::CsvTable table{commentsOfTable(), curveColumns(m_series, titles.angleColumn, settings().channel, titles.unit)};
  table.comments.push_back("values: " + titles.values);
  for (const std::string& comment : fixedForCsv()) table.comments.push_back(comment);
  return table;
}

double CurveChart::angleAt(const QPointF& position) const { return m_chart->xAxis->pixelToCoord(position.x()); }

QPointF CurveChart::handle() const {
  const QRect rect = m_chart->axisRect()->rect();
  return {m_chart->xAxis->coordToPixel(incidence().value_or(0)), double(rect.center().y())};
}

bool CurveChart::isOnLine(const QPointF& position) const {
  return incidence() && m_chart->axisRect()->rect().contains(position.toPoint()) &&
         std::abs(position.x() - handle().x()) < fontMetrics().height() * 0.5;
}

void CurveChart::pointerMoved(const QPointF& position) {
  const bool inside = m_chart->axisRect()->rect().contains(position.toPoint()) && !isEmpty();
  const double angle = angleAt(position);
  m_crosshair->setVisible(inside);
  setVertical(m_crosshair, angle);
  const ChartAxes titles = axes();
  showReadout(inside ? QStringLiteral("%1 = %2\n%3")
                           .arg(titles.angleTitle.section(' ', 0, 0), degreesText(radians(angle)),
                                curveReadout(m_series, radians(angle), settings().channel, titles.unitText))
                     : QString(),
              position);
  m_chart->setCursor(isOnLine(position) ? Qt::SplitHCursor : Qt::ArrowCursor);
  m_chart->replot(QCustomPlot::rpQueuedReplot);
}

bool CurveChart::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_chart) return Plot::eventFilter(watched, event);
  auto* mouse = dynamic_cast<QMouseEvent*>(event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      setFocus(Qt::MouseFocusReason);
      if (mouse->button() != Qt::LeftButton) return false;
      m_draggingLine = isOnLine(mouse->position());
      return m_draggingLine;
    case QEvent::MouseMove:
      pointerMoved(mouse->position());
      if (m_draggingLine) editThetaI(std::abs(radians(angleAt(mouse->position()))));
      if (!m_draggingLine && mouse->buttons() & Qt::LeftButton) m_viewChanged = true;
      return m_draggingLine;
    case QEvent::MouseButtonRelease:
      m_draggingLine = false;
      return false;
    case QEvent::MouseButtonDblClick:
      resetView();
      return true;
    case QEvent::Wheel: {
      // Beside an axis only that axis zooms.
      const QPoint at = static_cast<QWheelEvent*>(event)->position().toPoint();
      const QRect inner = m_chart->axisRect()->rect();
      const Qt::Orientations all = Qt::Horizontal | Qt::Vertical;
      m_chart->axisRect()->setRangeZoom(at.x() < inner.left()     ? Qt::Orientations(Qt::Vertical)
                                        : at.y() > inner.bottom() ? Qt::Orientations(Qt::Horizontal)
                                                                  : all);
      m_viewChanged = true;
      return false;
    }
    default:
      return false;
  }
}

void CurveChart::leaveEvent(QEvent* event) {
  Plot::leaveEvent(event);
  m_crosshair->setVisible(false);
  m_chart->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace gonio::widgets

#include "moc_curve_chart.cpp"
