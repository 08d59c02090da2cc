// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/curves/curve_editor.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/editing/curve_drag.h"
#include "core/math/monotone_cubic.h"

namespace gonio::widgets {

namespace {
constexpr double pointFraction = 0.02;
constexpr int maxPoints = 9;
constexpr double pointRadius = 4.5;
}  // namespace

CurveEditor::CurveEditor(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(200, 120);
  setAccessibleName(tr("Curve"));
}

QSize CurveEditor::sizeHint() const { return QSize(26, 14) * fontMetrics().height(); }

void CurveEditor::setAxis(const CurveAxis& axis) {
  m_view.axis = axis;
  setAccessibleName(axis.title);
  const QString help = axis.help.isEmpty() ? QString() : axis.help + QLatin1Char('\n');
  setToolTip(tr("%1\n"
                "Horizontal axis: %2. Vertical axis: %3.\n"
                "%4Drag points (Shift: fine steps), or drag a box to select several (Shift: adds to the selection). "
                "Escape cancels a drag.\n"
                "Double-click adds a point, Delete removes it.\n"
                "Tab moves from point to point, the arrow keys move a point (Shift: fine steps), Ctrl+A selects all.")
                 .arg(axis.title, axis.label, axis.valueLabel, help));
  setWhatsThis(toolTip());
  layOut();
}

void CurveEditor::setCurves(const std::vector<double>& nodes, const ChannelCurves& curves, const ChannelCurves& ghost) {
  const bool same = nodes == m_nodes && curves == m_curves;
  const bool another = nodes != m_nodes || ghost != m_ghost;
  m_nodes = nodes;
  m_curves = curves;
  m_ghost = ghost;
  if (another || (!same && !m_dragging)) choosePoints();
  layOut();
}

void CurveEditor::clear() {
  m_dragging = m_boxing = false;
  setCurves({}, {}, {});
}

void CurveEditor::setChannel(int channel) {
  if (channel == m_channel) return;
  m_channel = channel;
  choosePoints();
  update();
}

void CurveEditor::setLogarithmic(bool logarithmic) {
  m_view.logarithmic = logarithmic;
  layOut();
}

void CurveEditor::setLimits(const std::vector<CurveLimit>& limits, double reach) {
  m_view.limits = limits;
  m_view.reach = reach;
  update();
}

void CurveEditor::setHint(const QString& hint) {
  m_hint = hint;
  update();
}

void CurveEditor::layOut() {
  const QFontMetrics metrics = fontMetrics();
  const double left = metrics.horizontalAdvance(QStringLiteral("0.0001")) + 10, line = metrics.height();
  m_view.area = QRectF(left, 1.4 * line, std::max(10.0, width() - left - line), std::max(10.0, height() - 4.2 * line));
  if (!m_nodes.empty()) m_view.last = m_nodes.back();
  if (!m_dragging) m_view.fitTo(m_curves, m_ghost);
  update();
}

void CurveEditor::resizeEvent(QResizeEvent*) { layOut(); }

std::vector<double> CurveEditor::shownCurve(const ChannelCurves& curves) const {
  if (m_channel != allChannels) return curves[std::size_t(m_channel)];
  std::vector<double> mean(m_nodes.size());
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = (curves[0][i] + curves[1][i] + curves[2][i]) / 3;
  return mean;
}

void CurveEditor::choosePoints() {
  m_points = m_nodes.empty() ? std::vector<double>()
                             : editing::controlPoints(m_nodes, shownCurve(m_curves), pointFraction, maxPoints);
  m_selected.assign(m_points.size(), false);
  m_current = -1;
  // The hovered point belonged to the previous curves.
  m_hovered.reset();
  m_announced.clear();
  setAccessibleDescription({});
}

double CurveEditor::valueAt(double place) const {
  const std::vector<double> curve = shownCurve(m_curves);
  return evaluateMonotoneCubic(m_nodes, curve, monotoneSlopes(m_nodes, curve), place);
}

QPointF CurveEditor::pointPosition(std::size_t point) const {
  const double y = m_view.toY(valueAt(m_points[point]));
  return {m_view.toX(m_points[point]), std::clamp(y, m_view.area.top(), m_view.area.bottom())};
}

void CurveEditor::beginDrag() {
  m_curvesBefore = m_curves;
  m_pointsBefore = m_points;
}

void CurveEditor::cancelDrag() {
  m_curves = m_curvesBefore;
  m_points = m_pointsBefore;
  edited();
  m_dragging = false;
  Q_EMIT interactionEnded();
  layOut();
}

double CurveEditor::reachableDistance(double pixels) const {
  // Beside a neighbour that stays, or at the ends of the axis. Points that are close to each other move half way.
  constexpr double closest = 8;
  for (std::size_t i = 1; i < m_points.size(); ++i) {
    const bool isEnd = m_pointsBefore[i - 1] <= 0, moves = m_selected[i] && m_pointsBefore[i] < m_view.last;
    const bool moved = m_selected[i - 1] && !isEnd;
    if (moves == moved) continue;
    const double apart = m_view.toX(m_pointsBefore[i]) - m_view.toX(m_pointsBefore[i - 1]);
    const double room = apart - std::min(closest, apart / 2);
    pixels = moves ? std::max(pixels, -room) : std::min(pixels, room);
  }
  return pixels;
}

void CurveEditor::dragBy(const QPointF& pixels) {
  using editing::CurveDrag;
  const std::vector<double> shown = shownCurve(m_curvesBefore), slopes = monotoneSlopes(m_nodes, shown);
  CurveDrag drag{.from = m_pointsBefore, .to = m_pointsBefore, .amounts = {}};
  std::vector<double> factors, differences;
  const double nearly = 1e-3 * m_view.high;
  const double distance = reachableDistance(pixels.x());
  bool reachable = true;  // by factors
  for (std::size_t i = 0; i < drag.to.size(); ++i) {
    const double before = evaluateMonotoneCubic(m_nodes, shown, slopes, m_pointsBefore[i]);
    double after = before;
    if (m_selected[i]) {
      if (drag.to[i] > 0 && drag.to[i] < m_view.last)
        drag.to[i] = m_view.toPlace(m_view.toX(m_pointsBefore[i]) + distance);
      if (pixels.y() != 0) after = m_view.toValue(m_view.toY(before) + pixels.y());
      reachable = reachable && (after == before || before > (m_view.logarithmic ? m_view.low : nearly));
    }
    factors.push_back(before > 0 ? after / before : 1);
    differences.push_back(after - before);
  }
  drag.mode =
      reachable && (m_view.logarithmic || m_channel == allChannels) ? CurveDrag::Mode::multiply : CurveDrag::Mode::add;
  drag.amounts = drag.mode == CurveDrag::Mode::multiply ? factors : differences;
  for (int channel = 0; channel < 3; ++channel)
    if (m_channel == allChannels || m_channel == channel)
      m_curves[std::size_t(channel)] = editing::draggedCurve(m_nodes, m_curvesBefore[std::size_t(channel)], drag);
  m_points = drag.to;
  edited();
}

void CurveEditor::edited() {
  update();
  Q_EMIT curvesEdited(m_curves);
  announce();
}

void CurveEditor::announce() {
  m_announced.clear();
  if (m_current >= 0 && std::size_t(m_current) < m_points.size()) {
    const double place = m_points[std::size_t(m_current)];
    m_announced = tr("Point %1 of %2: %3 at %4")
                      .arg(m_current + 1)
                      .arg(m_points.size())
                      .arg(valueAt(place), 0, 'g', 4)
                      .arg(m_view.axis.place(place));
    Q_EMIT pointedAt(place);
  }
  setAccessibleDescription(m_announced);
  Q_EMIT announced(m_announced);
}

QString CurveEditor::valuesAt(double place) const {
  const auto value = [&](const ChannelCurves& curves, std::size_t channel) {
    return QString::number(
        evaluateMonotoneCubic(m_nodes, curves[channel], monotoneSlopes(m_nodes, curves[channel]), place), 'g', 3);
  };
  const QString where = m_view.axis.place(place);
  if (m_channel == allChannels)
    return tr("%1: %2 red, %3 green, %4 blue").arg(where, value(m_curves, 0), value(m_curves, 1), value(m_curves, 2));
  return tr("%1: %2, as measured %3")
      .arg(where, value(m_curves, std::size_t(m_channel)), value(m_ghost, std::size_t(m_channel)));
}

void CurveEditor::drawCurves(QPainter& painter, const PlotStyle& style) const {
  for (int channel = 0; channel < 3; ++channel) {
    const bool shown = m_channel == allChannels || m_channel == channel;
    m_view.drawCurve(painter, m_nodes, m_ghost[std::size_t(channel)], ghostPen(channel, style, shown ? 0.45 : 0.2));
    if (shown) m_view.drawCurve(painter, m_nodes, m_curves[std::size_t(channel)], style.channelPen(channel));
  }
  // The points of linked channels lie on their mean.
  if (m_channel == allChannels) m_view.drawCurve(painter, m_nodes, shownCurve(m_curves), meanPen(style));
}

void CurveEditor::drawPoints(QPainter& painter, const PlotStyle& style) const {
  for (std::size_t i = 0; i < m_points.size(); ++i) {
    const QPointF at = pointPosition(i);
    painter.setPen(QPen(style.text, 1.5));
    painter.setBrush(m_selected[i] ? style.accent : style.background);
    painter.drawEllipse(at, pointRadius, pointRadius);
    if (int(i) != m_current || !hasFocus()) continue;
    painter.setPen(QPen(style.accent, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, pointRadius + 4, pointRadius + 4);
  }
}

void CurveEditor::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const PlotStyle style = PlotStyle::of(palette());
  painter.fillRect(rect(), style.background);
  if (m_nodes.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, m_hint);
    return;
  }
  const double line = fontMetrics().height();
  m_view.drawFrame(painter, style);
  painter.drawText(QRectF(4, 2, width() - 8.0, line), Qt::AlignLeft, m_view.axis.title);
  painter.drawText(QRectF(4, 2, width() - 8.0, line), Qt::AlignRight, m_view.axis.valueLabel);
  const QString below = m_hovered && !m_dragging               ? valuesAt(*m_hovered)
                        : m_announced.isEmpty() || !hasFocus() ? m_view.axis.label
                                                               : m_announced;
  painter.drawText(QRectF(4, height() - 1.4 * line, width() - 8.0, line), Qt::AlignCenter, below);
  drawCurves(painter, style);
  m_view.drawLimits(painter, style);
  if (m_hovered && !m_dragging && !m_boxing) {
    painter.setPen(QPen(style.text, 0.8));
    const double x = m_view.toX(*m_hovered);
    painter.drawLine(QPointF(x, m_view.area.top()), QPointF(x, m_view.area.bottom()));
  }
  drawPoints(painter, style);
  if (m_boxing) {
    painter.setPen(QPen(style.accent, 1, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(m_pressed, m_boxEnd).normalized());
  }
  if (hasFocus()) {
    painter.setPen(QPen(style.accent, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
  }
}

}  // namespace gonio::widgets

#include "moc_curve_editor.cpp"
