// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/plots/lobe_plot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <optional>

#include "widgets/inputs/number_field.h"
#include "widgets/plots/plot_series.h"

namespace gonio::widgets {

namespace {

struct Face {
  double depth;
  std::array<std::size_t, 4> corners;
};

/// Faces whose corners are all known, the farthest first.
std::vector<Face> sortedFaces(const plots::LobeSurface& lobe, const std::vector<Direction>& points,
                              const Direction& toEye) {
  std::vector<Face> faces;
  for (int ring = 0; ring + 1 < lobe.rings; ++ring)
    for (int sector = 0; sector < lobe.sectors; ++sector) {
      const std::array corners{lobe.index(ring, sector), lobe.index(ring + 1, sector), lobe.index(ring + 1, sector + 1),
                               lobe.index(ring, sector + 1)};
      double depth = 0;
      bool known = true;
      for (const std::size_t corner : corners) {
        known = known && lobe.points.states[corner] == plots::PointState::known;
        depth += glm::dot(points[corner], toEye);
      }
      if (known) faces.push_back({depth, corners});
    }
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.depth < b.depth; });
  return faces;
}

QColor surfaceColour(SeriesRole role, const PlotStyle& style) {
  // The colour of text has no shades; the measured surface is grey.
  return role == SeriesRole::measured ? QColor(0xb4, 0xb4, 0xb4) : style.colour(role).lighter(style.dark ? 100 : 135);
}

void drawSurface(QPainter& painter, const LobePlace& place, const LobePicture& picture, const PlotStyle& style) {
  const plots::LobeSurface& lobe = picture.series.data;
  std::vector<Direction> points(lobe.directions.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = lobePoint(picture, i);
  const Direction toEye = place.view.toEye();
  const Direction toLamp = glm::normalize(toEye + 0.6 * place.view.up() - 0.5 * place.view.right());
  const QColor colour = surfaceColour(picture.series.role, style);
  for (const Face& face : sortedFaces(lobe, points, toEye)) {
    const auto& [a, b, c, d] = face.corners;
    const Direction normal = glm::cross(points[c] - points[a], points[d] - points[b]);
    const double length = glm::length(normal);
    if (!(length > 0)) continue;
    const double light = 0.35 + 0.65 * std::abs(glm::dot(normal, toLamp)) / length;
    const QColor shade(int(colour.red() * light), int(colour.green() * light), int(colour.blue() * light));
    const QPointF corners[] = {place.at(points[a]), place.at(points[b]), place.at(points[c]), place.at(points[d])};
    painter.setPen(QPen(shade, 1));  // closes the seams that antialiasing leaves between neighbours
    painter.setBrush(shade);
    painter.drawConvexPolygon(corners, 4);
  }
  painter.setBrush(Qt::NoBrush);
}

void drawGround(QPainter& painter, const LobePlace& place, const PlotStyle& style) {
  QPolygonF circle;
  for (int i = 0; i < 96; ++i) circle << place.at(fromSpherical(halfPi, 2 * pi * i / 96));
  QColor ground = style.grid;
  ground.setAlpha(90);
  painter.setPen(QPen(style.text, 1));
  painter.setBrush(ground);
  painter.drawPolygon(circle);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(style.gridPen());
  painter.drawLine(place.at({-1, 0, 0}), place.at({1, 0, 0}));
  painter.drawLine(place.at({0, -1, 0}), place.at({0, 1, 0}));
}

void drawArrowHead(QPainter& painter, const QPointF& from, const QPointF& to, double head) {
  const QPointF along = from - to;
  const double length = std::hypot(along.x(), along.y());
  if (length < head) return;
  const QPointF step = along / length * head, aside(-step.y() * 0.4, step.x() * 0.4);
  painter.drawPolygon(QPolygonF{to, to + step + aside, to + step - aside});
}

/// How far the surface reaches along a direction, as a fraction of the unit hemisphere.
double reachAlong(const LobePicture& picture, const Direction& direction) {
  const std::vector<Direction>& directions = picture.series.data.directions;
  const auto nearest = std::max_element(directions.begin(), directions.end(), [&](const auto& a, const auto& b) {
    return glm::dot(a, direction) < glm::dot(b, direction);
  });
  return nearest == directions.end() ? 0 : glm::length(lobePoint(picture, std::size_t(nearest - directions.begin())));
}

/// Axes from the origin outwards. The surface hides what lies within it: all is drawn before the surface, and again
/// after it those parts of axes toward the viewer that stand out of it.
void drawAxes(QPainter& painter, const LobePlace& place, const LobePicture& picture, const PlotStyle& style,
              bool afterSurface) {
  const double em = painter.fontMetrics().height();
  const Direction light = fromSpherical(picture.settings.thetaI, pi),
                  mirror = fromSpherical(picture.settings.thetaI, 0);
  const auto draw = [&](const Direction& axis, double length, const QPen& pen, bool arrow) {
    if (afterSurface && glm::dot(axis, place.view.toEye()) < 0) return;
    const double from = afterSurface ? reachAlong(picture, axis) : 0;
    if (from >= length) return;
    painter.setPen(pen);
    painter.drawLine(place.at(length * axis), place.at(from * axis));
    if (!arrow || from > 0.45) return;
    painter.setBrush(pen.color());
    drawArrowHead(painter, place.at(length * axis), place.at(0.45 * axis), 0.7 * em);
    painter.setBrush(Qt::NoBrush);
  };
  draw(light, 1.12, style.accentPen(), true);
  draw(mirror, 1, QPen(style.accent, 1, Qt::DotLine), false);
  draw({0, 0, 1}, 1.08, QPen(style.text, 1), false);
}

void drawTexts(QPainter& painter, const QRectF& cell, const LobePlace& place, const LobePicture& picture,
               const PlotStyle& style) {
  const double em = painter.fontMetrics().height();
  painter.setPen(style.text);
  painter.drawText(cell.adjusted(0, 0.3 * em, 0, 0), Qt::AlignTop | Qt::AlignHCenter, picture.series.name);
  painter.drawText(place.at({0, 0, 1.08}) + QPointF(0.3 * em, 0), QObject::tr("n"));
  painter.drawText(place.at(1.14 * fromSpherical(picture.settings.thetaI, pi)) + QPointF(-2 * em, -0.3 * em),
                   QObject::tr("θi %1").arg(degreesText(picture.settings.thetaI)));
  QString scale = QObject::tr("circle: %1 1/sr").arg(formatNumber(picture.scale.max));
  if (picture.scale.logarithmic)
    scale = QObject::tr("logarithmic, centre: %1 1/sr, %2").arg(formatNumber(picture.scale.min), scale);
  painter.drawText(cell.adjusted(0, 0, 0, -0.3 * em), Qt::AlignBottom | Qt::AlignHCenter, scale);
}

}  // namespace

Direction LobeView::toEye() const {
  return {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)};
}
Direction LobeView::right() const { return {-std::sin(yaw), std::cos(yaw), 0}; }
Direction LobeView::up() const { return glm::cross(toEye(), right()); }

LobePlace LobePlace::filling(const QRectF& cell, double fontHeight, const LobeView& view) {
  const double above = std::max(1.15 * std::cos(view.pitch), std::abs(std::sin(view.pitch)));
  const double below = std::abs(std::sin(view.pitch));
  const double height = cell.height() - 3.6 * fontHeight;
  const double radius = std::max(fontHeight, std::min(cell.width() / 2.5, height / (above + below)));
  const double top = cell.top() + 1.8 * fontHeight + (height - radius * (above + below)) / 2;
  return {view, {cell.center().x(), top + radius * above}, radius * view.zoom};
}

QPointF LobePlace::at(const Direction& point) const {
  return centre + radius * QPointF(glm::dot(point, view.right()), -glm::dot(point, view.up()));
}

Direction lobePoint(const LobePicture& picture, std::size_t index) {
  const plots::LobeSurface& lobe = picture.series.data;
  const double value = lobe.points.at(index, picture.settings.channel);
  return (std::isnan(value) ? 0.0 : picture.scale.fraction(value)) * lobe.directions[index];
}

void drawLobe(QPainter& painter, const QRectF& cell, const LobePlace& place, const LobePicture& picture,
              const PlotStyle& style) {
  painter.setRenderHint(QPainter::Antialiasing);
  drawGround(painter, place, style);
  drawAxes(painter, place, picture, style, false);
  drawSurface(painter, place, picture, style);
  drawAxes(painter, place, picture, style, true);
  drawTexts(painter, cell, place, picture, style);
}

namespace {
constexpr double turnPerPixel = 0.008;  // rad, as the preview's
constexpr double maxLobePitch = radians(89);
constexpr double zoomPerNotch = 1.15, minZoom = 0.3, maxZoom = 40;
constexpr double lobePixelsPerKey = 20;
}  // namespace

LobePlot::LobePlot(QWidget* parent) : Plot(tr("3-D lobe"), parent) {
  setAccessibleDescription(
      tr("BRDF values over all directions of the viewer as a surface. Drag to rotate, wheel to zoom."));
}

void LobePlot::setSeries(PlotSeriesList<plots::LobeSurface> series) {
  m_series = std::move(series);
  showEmptiness();
  refresh();
}

void LobePlot::refresh() {
  std::vector<double> values;
  for (const auto& series : m_series)
    for (std::size_t i = 0; i < series.data.directions.size(); ++i)
      values.push_back(series.data.points.at(i, settings().channel));
  m_scale = plots::scaleFor(values, settings().logarithmic);
  update();
}

void LobePlot::resetView() {
  m_view = {};
  update();
}

QRectF LobePlot::cell(const QSize& size, std::size_t index) const {
  const double width = double(size.width()) / double(std::max<std::size_t>(1, m_series.size()));
  return {width * double(index), 0, width, double(size.height())};
}

LobePlace LobePlot::place(const QSize& size, std::size_t index) const {
  return LobePlace::filling(cell(size, index), fontMetrics().height(), m_view);
}

void LobePlot::draw(QPainter& painter, const QSize& size, const PlotStyle& style) const {
  painter.setFont(font());
  painter.fillRect(QRect({0, 0}, size), style.background);
  for (std::size_t i = 0; i < m_series.size(); ++i) {
    painter.save();
    painter.setClipRect(cell(size, i));
    drawLobe(painter, cell(size, i), place(size, i), {m_series[i], settings(), m_scale}, style);
    painter.restore();
  }
}

void LobePlot::drawOn(QPaintDevice& device, const QSize& size, const PlotStyle& style) {
  QPainter painter(&device);
  draw(painter, size, style);
}

void LobePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  draw(painter, size(), style());
}

io::CsvTable LobePlot::table() const {
  io::CsvTable table{commentsOfTable(), {}};
  table.comments.push_back("values: " + valueForCsv(settings()));
  table.comments.push_back(angleForCsv("theta_i", settings().thetaI) + "; phi_i = 180 degrees");
  if (m_series.empty()) return table;
  table.columns = {{"theta_o [degrees]", {}}, {"phi_o [degrees]", {}}};
  for (const Direction& direction : m_series.front().data.directions) {
    table.columns[0].values.push_back(degrees(polarAngle(direction)));
    table.columns[1].values.push_back(degrees(azimuth(direction)));
  }
  for (const auto& series : m_series) {
    io::CsvColumn column{series.name.toStdString() + " [1/sr]", {}};
    for (std::size_t i = 0; i < series.data.directions.size(); ++i)
      column.values.push_back(series.data.points.at(i, settings().channel));
    table.columns.push_back(std::move(column));
  }
  return table;
}

void LobePlot::turn(double dx, double dy) {
  m_view.yaw = std::remainder(m_view.yaw - turnPerPixel * dx, 2 * pi);
  m_view.pitch = std::clamp(m_view.pitch + turnPerPixel * dy, -maxLobePitch, maxLobePitch);
  update();
}

void LobePlot::zoom(double steps) {
  m_view.zoom = std::clamp(m_view.zoom * std::pow(zoomPerNotch, steps), minZoom, maxZoom);
  update();
}

/// The surface's nearest point under the pointer, in front where several lie there.
void LobePlot::showValueAt(const QPointF& position) {
  constexpr double reach = 10;  // pixels
  for (std::size_t i = 0; i < m_series.size(); ++i) {
    if (!cell(size(), i).contains(position)) continue;
    const LobePlace at = place(size(), i);
    const LobePicture picture{m_series[i], settings(), m_scale};
    std::optional<std::size_t> nearest;
    double best = -2;
    for (std::size_t point = 0; point < m_series[i].data.directions.size(); ++point) {
      const Direction where = lobePoint(picture, point);
      const QPointF aside = at.at(where) - position;
      const double distance = std::hypot(aside.x(), aside.y());
      const double depth = glm::dot(where, m_view.toEye()) - distance / reach;
      if (distance < reach && depth > best) best = depth, nearest = point;
    }
    if (!nearest) return showReadout({});
    const Direction& direction = m_series[i].data.directions[*nearest];
    const plots::PlottedValues& points = m_series[i].data.points;
    return showReadout(tr("θo = %1, φo = %2\n%3: %4")
                           .arg(degreesText(polarAngle(direction)), degreesText(azimuth(direction)), m_series[i].name,
                                valueText(points.at(*nearest, settings().channel), points.states[*nearest])),
                       position);
  }
}

void LobePlot::mousePressEvent(QMouseEvent* event) { m_lastPosition = event->position(); }

void LobePlot::mouseMoveEvent(QMouseEvent* event) {
  const QPointF delta = event->position() - m_lastPosition;
  m_lastPosition = event->position();
  if (!(event->buttons() & Qt::LeftButton)) return showValueAt(event->position());
  showReadout({});
  turn(delta.x(), delta.y());
}

void LobePlot::mouseDoubleClickEvent(QMouseEvent*) { resetView(); }

void LobePlot::wheelEvent(QWheelEvent* event) {
  zoom(event->angleDelta().y() / 120.0);
  event->accept();
}

void LobePlot::keyPressEvent(QKeyEvent* event) {
  const bool turning = event->modifiers() & Qt::ControlModifier;
  const double step = event->modifiers() & Qt::ShiftModifier ? lobePixelsPerKey / 10 : lobePixelsPerKey;
  if (turning && event->key() == Qt::Key_Left) return turn(-step, 0);
  if (turning && event->key() == Qt::Key_Right) return turn(step, 0);
  if (event->key() == Qt::Key_Up) return turn(0, -step);
  if (event->key() == Qt::Key_Down) return turn(0, step);
  if (event->key() == Qt::Key_Plus) return zoom(1);
  if (event->key() == Qt::Key_Minus) return zoom(-1);
  Plot::keyPressEvent(event);
}

}  // namespace gonio::widgets

#include "moc_lobe_plot.cpp"
