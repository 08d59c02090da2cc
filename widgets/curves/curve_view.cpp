// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/curves/curve_view.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "core/math/monotone_cubic.h"

namespace gonio::widgets {

namespace {
constexpr double decades = 4;
constexpr double stepPixels = 2;
}  // namespace

QString CurveAxis::place(double at) const {
  return QStringLiteral("%1 %2%3").arg(symbol, QString::number(at / unit, 'g', 3), suffix);
}

void CurveView::fitTo(const ChannelCurves& curves, const ChannelCurves& ghost) {
  double largest = 0;
  for (const ChannelCurves* set : {&curves, &ghost})
    for (const std::vector<double>& curve : *set)
      for (const double value : curve) largest = std::max(largest, value);
  if (largest <= 0) largest = 1;
  high = logarithmic ? largest * 2 : largest * 1.15;
  low = logarithmic ? largest * std::pow(10.0, -decades) : 0;
}

double CurveView::toX(double place) const {
  const double fraction = std::max(0.0, place / last);
  return area.left() + area.width() * (axis.squareRoot ? std::sqrt(fraction) : fraction);
}

double CurveView::toPlace(double x) const {
  const double fraction = std::clamp((x - area.left()) / area.width(), 0.0, 1.0);
  return last * (axis.squareRoot ? fraction * fraction : fraction);
}

double CurveView::toY(double value) const {
  const double fraction =
      logarithmic ? std::log(std::max(value, low) / low) / std::log(high / low) : (value - low) / (high - low);
  return area.bottom() - area.height() * fraction;
}

double CurveView::toValue(double y) const {
  const double fraction = (area.bottom() - y) / area.height();
  return logarithmic ? low * std::pow(high / low, fraction) : std::max(0.0, low + (high - low) * fraction);
}

void CurveView::drawFrame(QPainter& painter, const PlotStyle& style) const {
  const QFontMetrics metrics = painter.fontMetrics();
  const auto horizontal = [&](double value) {
    const double y = toY(value);
    painter.setPen(style.gridPen());
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(style.text);
    painter.drawText(QRectF(0, y - metrics.height(), area.left() - 4, 2 * metrics.height()),
                     Qt::AlignRight | Qt::AlignVCenter, QString::number(value, 'g', 3));
  };
  if (logarithmic) {
    for (double value = std::pow(10.0, std::ceil(std::log10(low))); value <= high; value *= 10) horizontal(value);
  } else {
    const double size = std::pow(10.0, std::floor(std::log10(high / 2)));
    const double step = high / size > 10 ? 5 * size : high / size > 4 ? 2 * size : size;
    for (double value = 0; value <= high; value += step) horizontal(value);
  }
  double freeFrom = 0;
  const double units = last / axis.unit;
  for (double at = 0; at <= units * 1.001; at += axis.tick) {
    const double x = toX(at * axis.unit);
    painter.setPen(style.gridPen());
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    const QString text = QString::number(at, 'g', 3);
    const double width = metrics.horizontalAdvance(text);
    if (x - width / 2 < freeFrom) continue;
    painter.setPen(style.text);
    painter.drawText(QRectF(x - width, area.bottom() + 2, 2 * width, metrics.height()), Qt::AlignCenter, text);
    freeFrom = x + width;
  }
  painter.setPen(style.text);
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(area);
}

void CurveView::drawLimits(QPainter& painter, const PlotStyle& style) const {
  const QFontMetricsF metrics(painter.fontMetrics());
  const double line = metrics.height();
  if (reach < last) {
    QColor veil = style.text;
    veil.setAlphaF(0.12f);
    painter.fillRect(QRectF(QPointF(toX(reach), area.top()), area.bottomRight()), veil);
  }
  double top = area.top() + 2;
  for (const CurveLimit& limit : limits) {
    const double x = toX(limit.place), width = metrics.horizontalAdvance(limit.name);
    painter.setPen(QPen(style.text, 1, Qt::DotLine));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    const bool left = x - width - 6 > area.left();
    const QRectF text(left ? x - width - 4 : x + 4, top, width + 1, line);
    QColor paper = style.background;
    paper.setAlphaF(0.8f);
    painter.fillRect(text, paper);
    painter.setPen(style.text);
    painter.drawText(text, Qt::AlignLeft, limit.name);
    top += line;
  }
}

void CurveView::drawCurve(QPainter& painter, const std::vector<double>& nodes, const std::vector<double>& curve,
                          const QPen& pen) const {
  if (nodes.empty() || curve.size() != nodes.size()) return;
  const std::vector<double> slopes = monotoneSlopes(nodes, curve);
  QPainterPath path;
  for (double x = area.left(); x <= area.right(); x += stepPixels) {
    const QPointF point(
        x, std::clamp(toY(evaluateMonotoneCubic(nodes, curve, slopes, toPlace(x))), area.top(), area.bottom()));
    x == area.left() ? path.moveTo(point) : path.lineTo(point);
  }
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(path);
}

QPen ghostPen(int channel, const PlotStyle& style, double opacity) {
  QPen pen = style.channelPen(channel);
  QColor faint = pen.color();
  faint.setAlphaF(float(opacity));
  pen.setColor(faint);
  pen.setWidthF(1.2);
  return pen;
}

QPen meanPen(const PlotStyle& style) { return QPen(style.text, 0.8); }

namespace {
constexpr double sampleEms = 2, gapEms = 0.4, spaceEms = 1;
constexpr int meanEntry = 3;
}  // namespace

CurveLegend::CurveLegend(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  setAccessibleName(tr("Legend: %1").arg(names().join(QStringLiteral(", "))));
  setToolTip(
      tr("Solid: red; long dashes: green; short dashes: blue. The thin line is the mean of the three; its points move\n"
         "all channels together. Faint lines: curves of the measurement."));
}

QStringList CurveLegend::names() const { return {tr("red"), tr("green"), tr("blue"), tr("mean"), tr("as measured")}; }

QSize CurveLegend::sizeHint() const {
  const double em = fontMetrics().height();
  double width = 0;
  for (const QString& name : names())
    width += fontMetrics().horizontalAdvance(name) + (sampleEms + gapEms + spaceEms) * em;
  return {int(width), int(1.4 * em)};
}

void CurveLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const PlotStyle style = PlotStyle::of(palette());
  const double em = fontMetrics().height(), middle = height() / 2.0;
  const QStringList texts = names();
  double x = 0;
  for (int i = 0; i < texts.size(); ++i) {
    const double end = x + sampleEms * em;
    painter.setPen(i < meanEntry ? style.channelPen(i) : i == meanEntry ? meanPen(style) : ghostPen(0, style, 0.45));
    painter.drawLine(QPointF(x, middle), QPointF(end, middle));
    painter.setPen(palette().color(QPalette::WindowText));
    const double width = fontMetrics().horizontalAdvance(texts[i]);
    painter.drawText(QRectF(end + gapEms * em, 0, width + 1, height()), Qt::AlignVCenter, texts[i]);
    x = end + gapEms * em + width + spaceEms * em;
  }
}

}  // namespace gonio::widgets

#include "moc_curve_view.cpp"
