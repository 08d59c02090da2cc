// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/plots/polar_plot.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "widgets/inputs/number_field.h"
#include "widgets/plots/curve_series.h"
#include "widgets/plots/plot_text.h"

namespace gonio::widgets {

namespace {
constexpr double polarZoomPerNotch = 1.25, maxPolarZoom = 200;
}

PolarPlot::PolarPlot(QWidget* parent) : Plot(tr("Polar lobe"), parent) {
  setAccessibleDescription(tr("BRDF values vs. the polar angle of the viewer in the plane of incidence."));
}

void PolarPlot::setSeries(PlotSeriesList<plots::Curve> series) {
  m_series = std::move(series);
  showEmptiness();
  refresh();
}

void PolarPlot::refresh() {
  m_scale = plots::scaleFor(shownValues(m_series, settings().channel), settings().logarithmic);
  update();
}

void PolarPlot::resetView() {
  m_zoom = 1;
  m_pan = {};
  update();
}

PolarGeometry PolarPlot::geometry(const QSize& size) const {
  PolarGeometry geometry = PolarGeometry::filling(size, fontMetrics().height());
  geometry.centre += m_pan * geometry.radius;
  geometry.radius *= m_zoom;
  return geometry;
}

QPointF PolarPlot::handle() const { return geometry(size()).at(-settings().thetaI, 1); }

void PolarPlot::draw(QPainter& painter, const QSize& size, const PlotStyle& style) const {
  painter.setFont(font());
  drawPolar(painter, size, geometry(size), {m_series, settings(), m_scale}, style);
}

void PolarPlot::drawOn(QPaintDevice& device, const QSize& size, const PlotStyle& style) {
  QPainter painter(&device);
  draw(painter, size, style);
}

void PolarPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (isEmpty()) return painter.fillRect(rect(), style().background);
  draw(painter, size(), style());
  if (m_pointed) drawCrosshair(painter);
}

void PolarPlot::drawCrosshair(QPainter& painter) const {
  const PolarGeometry place = geometry(size());
  painter.setPen(QPen(style().text, 1, Qt::DashLine));
  painter.drawLine(place.centre, place.at(*m_pointed, 1));
  for (const auto& series : m_series) {
    const double value = plots::valueAt(series.data, *m_pointed, settings().channel);
    if (std::isnan(value)) continue;
    painter.setPen(QPen(style().colour(series.role), 2));
    painter.setBrush(style().background);
    painter.drawEllipse(place.at(*m_pointed, m_scale.fraction(value)), 3.5, 3.5);
  }
}

io::CsvTable PolarPlot::table() const {
  io::CsvTable table{commentsOfTable(), curveColumns(m_series, "theta_o", settings().channel, "1/sr")};
  table.comments.push_back("values: " + valueForCsv(settings()));
  table.comments.push_back(angleForCsv("theta_i", settings().thetaI));
  table.comments.push_back(
      "theta_o > 0 lies on the side of the mirror direction, theta_o = -theta_i is the direction to the light");
  return table;
}

void PolarPlot::showValuesAt(const QPointF& position) {
  const double angle = geometry(size()).angleOf(position);
  m_pointed = std::abs(angle) <= halfPi && !isEmpty() ? std::optional(angle) : std::nullopt;
  showReadout(m_pointed ? QStringLiteral("θo = %1\n%2")
                              .arg(degreesText(angle), curveReadout(m_series, angle, settings().channel, tr("1/sr")))
                        : QString(),
              position);
  update();
}

bool PolarPlot::isOnLight(const QPointF& position) const {
  const PolarGeometry place = geometry(size());
  const QPointF toHandle = position - handle();
  const double em = fontMetrics().height();
  if (std::hypot(toHandle.x(), toHandle.y()) < em) return true;
  const double fraction = place.fractionOf(position);
  const double aside = fraction * place.radius * std::abs(std::sin(place.angleOf(position) + settings().thetaI));
  return fraction > 0.3 && fraction < 1.05 && place.angleOf(position) < 0 && aside < 0.4 * em;
}

void PolarPlot::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || isEmpty()) return Plot::mousePressEvent(event);
  m_lastPosition = event->position();
  m_drag = isOnLight(event->position()) ? Drag::light : Drag::pan;
}

void PolarPlot::mouseMoveEvent(QMouseEvent* event) {
  const QPointF position = event->position();
  if (m_drag == Drag::light) {
    const double angle = -geometry(size()).angleOf(position);
    editThetaI(angle > halfPi + 0.5 ? 0 : angle);
  } else if (m_drag == Drag::pan) {
    m_pan += (position - m_lastPosition) / PolarGeometry::filling(size(), fontMetrics().height()).radius;
    m_lastPosition = position;
  }
  setCursor(m_drag == Drag::pan   ? Qt::ClosedHandCursor
            : isOnLight(position) ? Qt::PointingHandCursor
                                  : Qt::ArrowCursor);
  showValuesAt(position);
}

void PolarPlot::mouseReleaseEvent(QMouseEvent* event) {
  m_drag = Drag::none;
  setCursor(isOnLight(event->position()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void PolarPlot::mouseDoubleClickEvent(QMouseEvent*) { resetView(); }

void PolarPlot::wheelEvent(QWheelEvent* event) {
  const PolarGeometry whole = PolarGeometry::filling(size(), fontMetrics().height());
  const double zoom =
      std::clamp(m_zoom * std::pow(polarZoomPerNotch, event->angleDelta().y() / 120.0), 1.0, maxPolarZoom);
  // The point under the pointer stays where it is.
  const QPointF pointer = (event->position() - whole.centre) / whole.radius;
  m_pan = zoom == 1 ? QPointF() : pointer - (pointer - m_pan) * (zoom / m_zoom);
  m_zoom = zoom;
  showValuesAt(event->position());
  event->accept();
}

void PolarPlot::leaveEvent(QEvent* event) {
  Plot::leaveEvent(event);
  m_pointed.reset();
  update();
}

}  // namespace gonio::widgets

#include "moc_polar_plot.cpp"
