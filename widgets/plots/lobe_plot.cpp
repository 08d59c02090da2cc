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
#include "widgets/plots/plot_text.h"

namespace gonio::widgets {

namespace {
constexpr double turnPerPixel = 0.008;  // rad, as the preview's
constexpr double maxPitch = radians(89);
constexpr double zoomPerNotch = 1.15, minZoom = 0.3, maxZoom = 40;
constexpr double keyPixels = 20;
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
  m_view.pitch = std::clamp(m_view.pitch + turnPerPixel * dy, -maxPitch, maxPitch);
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
  const double step = event->modifiers() & Qt::ShiftModifier ? keyPixels / 10 : keyPixels;
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
