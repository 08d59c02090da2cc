// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/plots/polar_drawing.h"

#include <algorithm>
#include <cmath>

#include "widgets/inputs/number_field.h"
#include "widgets/plots/plot_text.h"

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

}  // namespace gonio::widgets
