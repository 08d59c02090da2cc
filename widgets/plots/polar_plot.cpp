// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/plots/polar_plot.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "widgets/inputs/number_field.h"
#include "widgets/plots/plot_series.h"

namespace gonio::widgets {

namespace {

constexpr double rayStep = radians(15);

double fontHeight(const QPainter& painter) { return painter.fontMetrics().height(); }

void drawCentred(QPainter& painter, const QPointF& at, const QString& text) {
  const QSizeF size = painter.fontMetrics().size(Qt::TextSingleLine, text);
  painter.drawText(QRectF(at - QPointF(size.width(), size.height()) / 2, size), Qt::AlignCenter, text);
}

QRectF discRect(const PolarGeometry& geometry, double fraction) {
  const double r = geometry.radius * fraction;
  return QRectF(geometry.centre - QPointF(r, r), QSizeF(2 * r, 2 * r));
}

void drawGrid(QPainter& painter, const PolarGeometry& geometry, const PolarPicture& picture, const PlotStyle& style) {
  painter.setPen(style.gridPen());
  painter.setBrush(Qt::NoBrush);
  for (int i = -6; i <= 6; ++i) painter.drawLine(geometry.centre, geometry.at(i * rayStep, 1));
  for (const double tick : plots::scaleTicks(picture.scale))
    painter.drawArc(discRect(geometry, picture.scale.fraction(tick)), 0, 180 * 16);
  painter.setPen(QPen(style.text, 1));
  painter.drawArc(discRect(geometry, 1), 0, 180 * 16);
  painter.drawLine(geometry.at(-halfPi, 1), geometry.at(halfPi, 1));
}

void drawAngles(QPainter& painter, const PolarGeometry& geometry, double thetaI, const PlotStyle& style) {
  const double away = 1 + 1.1 * fontHeight(painter) / geometry.radius;
  painter.setPen(style.text);
  for (int i = -6; i <= 6; i += 2) {
    const double angle = i * rayStep;
    if (std::abs(angle + thetaI) < radians(9)) continue;  // there stands the handle's own label
    drawCentred(painter, geometry.at(angle, away), QStringLiteral("%1°").arg(i * 15));
  }
}

void drawValues(QPainter& painter, const PolarGeometry& geometry, const PolarPicture& picture, const PlotStyle& style) {
  painter.setPen(style.text);
  const double below = 0.7 * fontHeight(painter);
  const auto label = [&](double fraction, double value) {
    for (const double side : {-1.0, 1.0})
      drawCentred(painter, geometry.centre + QPointF(side * fraction * geometry.radius, below), formatNumber(value));
  };
  const auto width = [&](double value) { return painter.fontMetrics().horizontalAdvance(formatNumber(value)); };
  const double gap = 0.5 * fontHeight(painter);
  double free = width(picture.scale.min) / 2.0 + gap;  // from there on no label stands, from the centre outwards
  for (const double tick : plots::scaleTicks(picture.scale)) {
    const double at = picture.scale.fraction(tick) * geometry.radius, half = width(tick) / 2.0;
    if (at - half < free) continue;
    label(picture.scale.fraction(tick), tick);
    free = at + half + gap;
  }
  drawCentred(painter, geometry.centre + QPointF(0, below), formatNumber(picture.scale.min));
  const QString title = picture.scale.logarithmic ? QObject::tr("%1, logarithmic").arg(valueTitle(picture.settings))
                                                  : valueTitle(picture.settings);
  drawCentred(painter, geometry.centre + QPointF(0, 2 * fontHeight(painter)), title);
}

void drawCurve(QPainter& painter, const PolarGeometry& geometry, const PolarPicture& picture,
               const plots::Curve& curve) {
  QPolygonF line;
  const auto flush = [&] {
    if (line.size() > 1) painter.drawPolyline(line);
    line.clear();
  };
  for (std::size_t i = 0; i < curve.angles.size(); ++i) {
    const double value = curve.points.at(i, picture.settings.channel);
    if (std::isnan(value))
      flush();
    else
      line << geometry.at(curve.angles[i], picture.scale.fraction(value));
  }
  flush();
}

void drawLight(QPainter& painter, const PolarGeometry& geometry, double thetaI, const PlotStyle& style) {
  const double em = fontHeight(painter);
  const QPointF rim = geometry.at(-thetaI, 1);
  painter.setPen(QPen(style.accent, 1, Qt::DotLine));
  painter.drawLine(geometry.centre, geometry.at(thetaI, 1));
  painter.setPen(style.accentPen());
  painter.drawLine(rim, geometry.centre);
  // The head of the arrow, toward the surface.
  const double tip = std::min(0.5, 1.4 * em / geometry.radius), spread = 0.3 * tip;
  const QPointF point = geometry.at(-thetaI, 0.55 - tip / 2);
  painter.setBrush(style.accent);
  painter.drawPolygon(
      QPolygonF{point, geometry.at(-thetaI - spread, 0.55 + tip / 2), geometry.at(-thetaI + spread, 0.55 + tip / 2)});
  painter.drawEllipse(rim, 0.4 * em, 0.4 * em);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(style.text);
  const QString label = QObject::tr("θi %1").arg(degreesText(thetaI));
  const double halfWidth = painter.fontMetrics().horizontalAdvance(label) / 2.0;
  const double away = 1 + (1.2 * em + halfWidth * std::sin(thetaI)) / geometry.radius;
  drawCentred(painter, geometry.at(-thetaI, away), label);
}

}  // namespace

PolarGeometry PolarGeometry::filling(const QSizeF& size, double height) {
  const double bottom = 2.8 * height, top = 1.9 * height, side = 4.5 * height;
  const double radius = std::max(height, std::min(size.width() / 2 - side, size.height() - bottom - top));
  return {{size.width() / 2, top + (size.height() - bottom - top + radius) / 2}, radius};
}

QPointF PolarGeometry::at(double angle, double fraction) const {
  return centre + radius * fraction * QPointF(std::sin(angle), -std::cos(angle));
}

double PolarGeometry::angleOf(const QPointF& point) const {
  return std::atan2(point.x() - centre.x(), centre.y() - point.y());
}

double PolarGeometry::fractionOf(const QPointF& point) const {
  return std::hypot(point.x() - centre.x(), point.y() - centre.y()) / radius;
}

void drawPolar(QPainter& painter, const QSizeF& size, const PolarGeometry& geometry, const PolarPicture& picture,
               const PlotStyle& style) {
  painter.fillRect(QRectF({0, 0}, size), style.background);
  painter.setRenderHint(QPainter::Antialiasing);
  drawGrid(painter, geometry, picture, style);
  drawAngles(painter, geometry, picture.settings.thetaI, style);
  drawValues(painter, geometry, picture, style);
  std::vector<std::pair<SeriesRole, QString>> legend;
  for (const auto& series : picture.series) {
    painter.setPen(style.pen(series.role));
    drawCurve(painter, geometry, picture, series.data);
    legend.emplace_back(series.role, series.name);
  }
  drawLight(painter, geometry, picture.settings.thetaI, style);
  drawLegend(painter, legend, style);
}

void drawLegend(QPainter& painter, const std::vector<std::pair<SeriesRole, QString>>& entries, const PlotStyle& style) {
  const double em = fontHeight(painter);
  double y = 0.9 * em;
  for (const auto& [role, name] : entries) {
    painter.setPen(style.pen(role));
    painter.drawLine(QPointF(0.6 * em, y), QPointF(3.2 * em, y));
    painter.setPen(style.text);
    painter.drawText(QPointF(3.7 * em, y + 0.35 * em), name);
    y += 1.2 * em;
  }
}

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
