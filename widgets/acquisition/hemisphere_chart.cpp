// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/acquisition/hemisphere_chart.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "widgets/charts/plot_style.h"

namespace gonio::widgets {

namespace {

constexpr int ringStep = 15, rayStep = 30;
constexpr double directionRadius = 4, markedDirectionRadius = 6;
/// Measures of the legend in heights of the font: a row, the distance of its first mark from the left, the gap between
/// entries beside the text.
constexpr double legendRowHeight = 1.3, legendLeft = 0.8, legendEntry = 1.8;
/// Azimuth of the ray with the labels of the rings. Nodes of a grid have their half vector at azimuth 0: few samples
/// lie on the other side.
constexpr double labelAzimuth = radians(188);

const SeriesRole lightRole = SeriesRole::edited, viewerRole = SeriesRole::fit;

/// A disc for the light, a diamond for the viewer: distinguishable without their colours.
void drawLight(QPainter& painter, const QPointF& at, double radius) { painter.drawEllipse(at, radius, radius); }
void drawViewer(QPainter& painter, const QPointF& at, double radius) {
  const double r = 1.25 * radius;
  painter.drawPolygon(QPolygonF{at + QPointF(0, -r), at + QPointF(r, 0), at + QPointF(0, r), at + QPointF(-r, 0)});
}

}  // namespace

HemisphereChart::HemisphereChart(QWidget* parent) : SampleChart(parent) {
  setAccessibleName(tr("Directions on the hemisphere"));
  setAccessibleDescription(
      tr("Light and viewer of each sample; the left and right arrow keys step through them in order."));
}

QSize HemisphereChart::sizeHint() const { return QSize(20, 20) * fontMetrics().height(); }

void HemisphereChart::setMaxPolarAngle(double angle) {
  m_maxPolarAngle = angle;
  update();
}

QRectF HemisphereChart::disc() const {
  const double em = fontMetrics().height();
  const QRectF room =
      QRectF(rect()).adjusted(2.5 * em, 1.5 * em, -2.3 * em, -(3.2 + legendRowHeight * (legendRows() - 1)) * em);
  const double side = std::max(em, std::min(room.width(), room.height()));
  return QRectF(room.center() - QPointF(side, side) / 2, QSizeF(side, side));
}

QPointF HemisphereChart::placeOf(const Direction& direction) const {
  const QRectF at = disc();
  const double fraction = polarAngle(direction) / halfPi, phi = azimuth(direction);
  return at.center() + 0.5 * at.width() * fraction * QPointF(std::cos(phi), -std::sin(phi));
}

QList<QPointF> HemisphereChart::places(int sample) const {
  const DirectionPair& pair = samples()[std::size_t(sample)];
  return {placeOf(pair.wi), placeOf(pair.wo)};
}

void HemisphereChart::drawGrid(QPainter& painter) const {
  const PlotStyle style = PlotStyle::of(palette());
  const QRectF rim = disc();
  const auto ring = [&](double fraction) {
    const double r = 0.5 * rim.width() * fraction;
    return QRectF(rim.center() - QPointF(r, r), QSizeF(2 * r, 2 * r));
  };
  if (m_maxPolarAngle < halfPi) {
    QPainterPath beyond;
    beyond.addEllipse(rim);
    beyond.addEllipse(ring(m_maxPolarAngle / halfPi));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QBrush(style.grid, Qt::BDiagPattern));
    painter.drawPath(beyond);
  }
  painter.setPen(style.gridPen());
  painter.setBrush(Qt::NoBrush);
  for (int angle = ringStep; angle < 90; angle += ringStep) painter.drawEllipse(ring(angle / 90.0));
  for (int angle = 0; angle < 360; angle += rayStep)
    painter.drawLine(rim.center(), placeOf(fromSpherical(halfPi, radians(angle))));
  painter.setPen(QPen(style.text, 1));
  painter.drawEllipse(rim);
}

void HemisphereChart::drawLabels(QPainter& painter) const {
  painter.setPen(PlotStyle::of(palette()).text);
  for (const auto& [text, box] : labels()) painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
}

std::vector<std::pair<QString, QRectF>> HemisphereChart::labels() const {
  const QRectF rim = disc();
  const double em = fontMetrics().height(), r = rim.width() / 2;
  std::vector<std::pair<QString, QRectF>> labels;
  const auto add = [&](const QString& text, const QPointF& offset) {
    QRectF box(QPointF(), QSizeF(fontMetrics().horizontalAdvance(text), em));
    box.moveCenter(rim.center() + offset);
    labels.emplace_back(text, box);
  };
  add(tr("φ 0°"), {r + 1.3 * em, 0});
  add(QStringLiteral("90°"), {0, -r - 0.7 * em});
  add(QStringLiteral("180°"), {-r - 1.4 * em, 0});
  add(QStringLiteral("270°"), {0, r + 0.7 * em});
  // Without samples the hint stands where the rings have their labels.
  if (!samples().empty()) std::ranges::move(ringLabels(), std::back_inserter(labels));
  return labels;
}

std::vector<std::pair<QString, QRectF>> HemisphereChart::ringLabels() const {
  std::vector<std::pair<QString, QRectF>> labels;
  // From outside, so that a small chart keeps the label of the larger ring.
  for (const int angle : {60, 30}) {
    const QString text = labels.empty() ? tr("θ %1°").arg(angle) : QStringLiteral("%1°").arg(angle);
    const QSizeF size(fontMetrics().horizontalAdvance(text) + 4, fontMetrics().height());
    const QPointF at = placeOf(fromSpherical(radians(angle), labelAzimuth));
    const QRectF box(at - QPointF(size.width(), size.height()) / 2, size);
    if (labels.empty() || !labels.front().second.intersects(box)) labels.emplace_back(text, box);
  }
  return labels;
}

void HemisphereChart::drawSample(QPainter& painter, int sample, bool marked) const {
  const PlotStyle style = PlotStyle::of(palette());
  const QList<QPointF> at = places(sample);
  QColor line = marked ? style.accent : style.text;
  if (!marked) line.setAlphaF(0.35f);
  painter.setPen(QPen(line, marked ? 2.0 : 1.0));
  painter.drawLine(at[0], at[1]);
  const double radius = marked ? markedDirectionRadius : directionRadius;
  painter.setPen(QPen(marked ? style.accent : style.background, marked ? 2 : 1));
  painter.setBrush(style.colour(lightRole));
  drawLight(painter, at[0], radius);
  painter.setBrush(style.colour(viewerRole));
  drawViewer(painter, at[1], radius);
}

QString HemisphereChart::beyondText() const { return tr("beyond %1°").arg(degrees(m_maxPolarAngle), 0, 'g', 3); }

/// Two where the angle that is left out has no room beside the others.
int HemisphereChart::legendRows() const {
  if (m_maxPolarAngle >= halfPi) return 1;
  const double em = fontMetrics().height();
  const auto textWidth = [this](const QString& text) { return double(fontMetrics().horizontalAdvance(text)); };
  const double marks = (legendLeft + 3 * legendEntry) * em;
  return marks + textWidth(tr("light")) + textWidth(tr("viewer")) + textWidth(beyondText()) > width() ? 2 : 1;
}

void HemisphereChart::drawLegend(QPainter& painter) const {
  const PlotStyle style = PlotStyle::of(palette());
  const double em = fontMetrics().height(), left = legendLeft * em;
  double x = left, y = height() - 0.8 * em - (legendRows() - 1) * legendRowHeight * em;
  const auto entry = [&](SeriesRole role, const QString& text, void (*shape)(QPainter&, const QPointF&, double)) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(style.colour(role));
    shape(painter, QPointF(x, y), directionRadius);
    painter.setPen(style.text);
    painter.drawText(QPointF(x + 0.6 * em, y + 0.35 * em), text);
    x += legendEntry * em + fontMetrics().horizontalAdvance(text);
  };
  entry(lightRole, tr("light"), drawLight);
  entry(viewerRole, tr("viewer"), drawViewer);
  if (m_maxPolarAngle < halfPi) {
    if (legendRows() > 1) x = left, y += legendRowHeight * em;
    painter.setPen(QPen(style.grid, 1));
    painter.setBrush(QBrush(style.text, Qt::BDiagPattern));
    painter.drawRect(QRectF(x - 0.4 * em, y - 0.35 * em, 0.9 * em, 0.7 * em));
    painter.setPen(style.text);
    painter.drawText(QPointF(x + 0.9 * em, y + 0.35 * em), beyondText());
  }
}

void HemisphereChart::paintEvent(QPaintEvent*) {
  const PlotStyle style = PlotStyle::of(palette());
  QPainter painter(this);
  painter.fillRect(rect(), style.background);
  painter.setRenderHint(QPainter::Antialiasing);
  drawGrid(painter);
  drawLabels(painter);
  for (int i = 0; i < int(samples().size()); ++i)
    if (i != current()) drawSample(painter, i, false);
  if (current() >= 0) drawSample(painter, current(), true);
  std::vector<QRectF> taken;
  for (const auto& label : labels()) taken.push_back(label.second);
  drawNumbers(painter, std::move(taken));
  drawLegend(painter);
  drawHint(painter, disc());
  drawFocus(painter);
}

}  // namespace gonio::widgets

#include "moc_hemisphere_chart.cpp"
