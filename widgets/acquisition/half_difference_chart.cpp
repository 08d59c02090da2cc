// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/acquisition/half_difference_chart.h"

#include <QCoreApplication>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "core/plots/plotted_values.h"
#include "core/rendering/error_maps.h"
#include "widgets/charts/plot_style.h"
#include "widgets/inputs/number_field.h"

namespace gonio::widgets {

namespace {

struct CellStateText {
  Q_DECLARE_TR_FUNCTIONS(CellState)
};

Qt::BrushStyle hatching(CellState state) {
  switch (state) {
    case CellState::belowHorizon:
      return Qt::SolidPattern;
    case CellState::grazing:
      return Qt::BDiagPattern;
    case CellState::forbidden:
      return Qt::DiagCrossPattern;
    case CellState::unlearned:
      return Qt::Dense5Pattern;
    case CellState::measurable:
      break;
  }
  return Qt::NoBrush;
}

}  // namespace

QString stateName(CellState state) {
  switch (state) {
    case CellState::belowHorizon:
      return CellStateText::tr("below the horizon");
    case CellState::grazing:
      return CellStateText::tr("beyond the max. polar angle");
    case CellState::forbidden:
      return CellStateText::tr("unreachable by the rig");
    case CellState::unlearned:
      return CellStateText::tr("missing in some materials");
    case CellState::measurable:
      break;
  }
  return CellStateText::tr("measurable");
}

QBrush stateBrush(CellState state, const PlotStyle& style) {
  QColor colour = style.text;
  colour.setAlphaF(state == CellState::belowHorizon ? 0.28f : 0.6f);
  return QBrush(colour, hatching(state));
}

namespace {

constexpr double dotRadius = 4.5, markedRadius = 6.5;
constexpr plots::ThetaHSpacing spacing = plots::ThetaHSpacing::squareRoot;

}  // namespace

HalfDifferenceChart::HalfDifferenceChart(QWidget* parent) : SampleChart(parent) {
  setAccessibleName(tr("Samples in half-difference space"));
  setAccessibleDescription(
      tr("Half angle vs. difference angle; the left and right arrow keys step through the samples."));
}

QSize HalfDifferenceChart::sizeHint() const { return QSize(23, 20) * fontMetrics().height(); }

void HalfDifferenceChart::setSlice(HalfDifferenceSlice slice) {
  m_slice = std::move(slice);
  paintImage();
  update();
}

void HalfDifferenceChart::setRange(double range) {
  m_range = range;
  paintImage();
  update();
}

QRectF HalfDifferenceChart::plot() const {
  const double em = fontMetrics().height();
  const double right = hasDeviations() ? 5.6 * em : 1.2 * em;
  return QRectF(rect()).adjusted(3.6 * em, 0.9 * em, -right, -5.5 * em);
}

QPointF HalfDifferenceChart::placeOf(double thetaH, double thetaD) const {
  const QRectF at = plot();
  return {at.left() + at.width() * thetaD / halfPi, at.bottom() - at.height() * plots::thetaHFraction(spacing, thetaH)};
}

QList<QPointF> HalfDifferenceChart::places(int sample) const {
  const DirectionPair& pair = samples()[std::size_t(sample)];
  const HalfDifference at = toHalfDifference(pair.wi, pair.wo);
  return {placeOf(at.thetaH, at.thetaD)};
}

bool HalfDifferenceChart::isInSlice(int sample) const {
  const DirectionPair& pair = samples()[std::size_t(sample)];
  const HalfDifference at = toHalfDifference(pair.wi, pair.wo);
  // Where one of the angles is 0, phi_d is nothing that could differ.
  constexpr double none = radians(0.5);
  if (at.thetaD < none || at.thetaH < none) return true;
  const double apart = std::abs(foldPhiD(at.phiD) - m_slice.phiD);
  return std::min(apart, pi - apart) <= sliceWidth;
}

QPointF HalfDifferenceChart::cellCentre(int thetaH, int thetaD) const {
  const QRectF at = plot();
  return {at.left() + at.width() * (thetaD + 0.5) / m_slice.thetaDCount,
          at.bottom() - at.height() * (thetaH + 0.5) / m_slice.thetaHCount};
}

int HalfDifferenceChart::cellAt(const QPointF& place) const {
  const QRectF at = plot();
  if (!at.contains(place) || m_slice.states.empty()) return -1;
  const int j = std::min(int((place.x() - at.left()) / at.width() * m_slice.thetaDCount), m_slice.thetaDCount - 1);
  const int i = std::min(int((at.bottom() - place.y()) / at.height() * m_slice.thetaHCount), m_slice.thetaHCount - 1);
  return i * m_slice.thetaDCount + j;
}

void HalfDifferenceChart::paintImage() {
  m_image = {};
  if (!hasDeviations()) return;
  m_image = QImage(m_slice.thetaDCount, m_slice.thetaHCount, QImage::Format_ARGB32_Premultiplied);
  m_image.fill(Qt::transparent);
  for (int i = 0; i < m_slice.thetaHCount; ++i)
    for (int j = 0; j < m_slice.thetaDCount; ++j) {
      const float deviation = m_slice.deviations[std::size_t(i * m_slice.thetaDCount + j)];
      if (std::isnan(deviation)) continue;
      const rendering::DisplayColour colour = rendering::viridis(double(deviation) / m_range);
      m_image.setPixelColor(j, m_slice.thetaHCount - 1 - i, QColor(colour[0], colour[1], colour[2]));
    }
}

void HalfDifferenceChart::drawShading(QPainter& painter) const {
  const PlotStyle style = PlotStyle::of(palette());
  const QRectF at = plot();
  if (!m_image.isNull()) painter.drawImage(at, m_image);
  if (m_slice.states.empty()) return;
  const double width = at.width() / m_slice.thetaDCount, height = at.height() / m_slice.thetaHCount;
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(Qt::NoPen);
  for (int i = 0; i < m_slice.thetaHCount; ++i)
    for (int j = 0; j < m_slice.thetaDCount;) {
      // Runs of equal cells: a rectangle each, so that the hatching goes on without seams.
      const auto row = m_slice.states.begin() + std::ptrdiff_t(i) * m_slice.thetaDCount;
      const CellState state = row[j];
      int end = j;
      while (end < m_slice.thetaDCount && row[end] == state) ++end;
      if (state != CellState::measurable) {
        painter.setBrush(stateBrush(state, style));
        const double top = std::round(at.bottom() - (i + 1) * height), bottom = std::round(at.bottom() - i * height);
        const double left = std::round(at.left() + j * width), right = std::round(at.left() + end * width);
        painter.drawRect(QRectF(left, top, right - left, bottom - top));
      }
      j = end;
    }
  painter.setRenderHint(QPainter::Antialiasing);
}

void HalfDifferenceChart::drawAxes(QPainter& painter) const {
  const PlotStyle style = PlotStyle::of(palette());
  const QRectF at = plot();
  const double em = fontMetrics().height(), tick = 0.3 * em;
  const auto line = [&](const QPointF& from, const QPointF& to) {
    painter.setPen(style.gridPen());
    painter.drawLine(from, to);
  };
  for (int mark = 0; mark <= 90; mark += 15) {
    const QPointF foot = placeOf(0, radians(mark));
    if (!hasDeviations()) line(foot, {foot.x(), at.top()});
    painter.setPen(style.text);
    painter.drawLine(foot, foot + QPointF(0, tick));
    drawCentred(painter, foot + QPointF(0, tick + 0.6 * em), QString::number(mark));
  }
  for (const int mark : {0, 1, 5, 10, 20, 30, 45, 60, 90}) {
    const QPointF foot = placeOf(radians(mark), 0);
    if (!hasDeviations()) line(foot, {at.right(), foot.y()});
    painter.setPen(style.text);
    painter.drawLine(foot, foot - QPointF(tick, 0));
    const QString text = QString::number(mark);
    painter.drawText(QRectF(foot - QPointF(3 * em + tick + 2, em / 2), QSizeF(3 * em, em)),
                     Qt::AlignRight | Qt::AlignVCenter, text);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(style.text, 1));
  painter.drawRect(at);
  drawCentred(painter, {at.center().x(), at.bottom() + 2.2 * em},
              tr("θd [°], at φd = %1").arg(degreesText(m_slice.phiD)));
  painter.save();
  painter.translate(0.8 * em, at.center().y());
  painter.rotate(-90);
  drawCentred(painter, {0, 0}, tr("θh [°]"));
  painter.restore();
}

void HalfDifferenceChart::drawSamples(QPainter& painter) const {
  const PlotStyle style = PlotStyle::of(palette());
  const auto draw = [&](int sample) {
    const bool marked = sample == current();
    const QPointF at = places(sample)[0];
    const double radius = marked ? markedRadius : dotRadius;
    // A rim of the background first: dots stay legible on every colour and on one another.
    painter.setPen(QPen(style.background, isInSlice(sample) ? 3 : 4));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, radius, radius);
    painter.setPen(QPen(marked ? style.accent : style.text, marked ? 2.2 : 1.4));
    painter.setBrush(isInSlice(sample) ? (marked ? style.accent : style.text) : style.background);
    painter.drawEllipse(at, radius, radius);
  };
  for (int i = 0; i < int(samples().size()); ++i)
    if (i != current()) draw(i);
  if (current() >= 0) draw(current());
  // The margins belong to the axes.
  const QRectF at = plot(), whole = rect();
  drawNumbers(painter, {QRectF(whole.topLeft(), QPointF(at.left(), whole.bottom())),
                        QRectF(QPointF(at.right(), whole.top()), whole.bottomRight()),
                        QRectF(QPointF(whole.left(), at.bottom()), whole.bottomRight())});
}

void HalfDifferenceChart::drawColourBar(QPainter& painter) const {
  if (!hasDeviations()) return;
  const PlotStyle style = PlotStyle::of(palette());
  const QRectF at = plot();
  const double em = fontMetrics().height();
  const QRectF bar(at.right() + 0.9 * em, at.top(), 0.8 * em, at.height());
  painter.setRenderHint(QPainter::Antialiasing, false);
  const int rows = int(bar.height());
  for (int y = 0; y < rows; ++y) {
    const rendering::DisplayColour colour = rendering::viridis(1 - double(y) / std::max(1, rows - 1));
    painter.fillRect(QRectF(bar.left(), bar.top() + y, bar.width(), 1), QColor(colour[0], colour[1], colour[2]));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(style.text, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(bar);
  for (int i = 0; i <= 4; ++i) {
    const double fraction = i / 4.0;
    const QString text = (i == 4 ? tr("≥ %1") : QStringLiteral("%1")).arg(formatNumber(fraction * m_range));
    painter.drawText(QRectF(bar.right() + 3, bar.bottom() - fraction * bar.height() - em / 2, 2.4 * em, em),
                     Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, text);
  }
  painter.save();
  painter.translate(width() - 0.8 * em, at.center().y());
  painter.rotate(-90);
  drawCentred(painter, {0, 0}, tr("Uncertainty: σ of the mapped value"));
  painter.restore();
}

std::vector<CellState> HalfDifferenceChart::shownStates() const {
  std::vector<CellState> shown;
  for (const CellState state : shadedStates)
    if (std::ranges::find(m_slice.states, state) != m_slice.states.end()) shown.push_back(state);
  return shown;
}

void HalfDifferenceChart::drawLegend(QPainter& painter) const {
  const PlotStyle style = PlotStyle::of(palette());
  const double em = fontMetrics().height(), left = 0.6 * em, gap = 1.1 * em;
  double x = left, y = height() - 1.85 * em;
  const auto entry = [&](const QString& text, const auto& symbol) {
    const double wide = 1.3 * em + fontMetrics().horizontalAdvance(text);
    if (x > left && x + wide > width()) {
      x = left;
      y += 1.15 * em;
    }
    symbol(QPointF(x + 0.45 * em, y));
    painter.setPen(style.text);
    painter.drawText(QPointF(x + 1.2 * em, y + 0.35 * em), text);
    x += wide + gap;
  };
  const auto dot = [&](bool full) {
    return [&, full](const QPointF& at) {
      painter.setPen(QPen(style.text, 1.4));
      painter.setBrush(full ? style.text : style.background);
      painter.drawEllipse(at, dotRadius, dotRadius);
    };
  };
  if (!samples().empty()) {
    entry(tr("φd within %1° of the slice").arg(degrees(sliceWidth), 0, 'g', 3), dot(true));
    entry(tr("other φd"), dot(false));
  }
  for (const CellState state : shownStates())
    entry(stateName(state), [&](const QPointF& at) {
      painter.setPen(QPen(style.text, 1));
      painter.setBrush(stateBrush(state, style));
      painter.drawRect(QRectF(at - QPointF(0.45, 0.35) * em, QSizeF(0.9, 0.7) * em));
    });
}

QString HalfDifferenceChart::toolTipOf(int sample) const {
  return SampleChart::toolTipOf(sample) + '\n' +
         (isInSlice(sample) ? tr("In the slice shown") : tr("Outside the slice shown"));
}

bool HalfDifferenceChart::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return SampleChart::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const int cell = sampleAt(help->pos()) >= 0 ? -1 : cellAt(help->pos());
  if (cell < 0) return SampleChart::event(event);
  const HalfDifferenceGrid grid{m_slice.thetaHCount, m_slice.thetaDCount, 1};
  const HalfDifference at = grid.node(std::size_t(cell));
  QString text = tr("θh %1, θd %2, φd %3: %4")
                     .arg(degreesText(at.thetaH), degreesText(at.thetaD), degreesText(m_slice.phiD),
                          stateName(m_slice.states[std::size_t(cell)]));
  if (hasDeviations() && !std::isnan(m_slice.deviations[std::size_t(cell)]))
    text +=
        '\n' +
        tr("Uncertainty, σ of the mapped value: %1").arg(formatNumber(double(m_slice.deviations[std::size_t(cell)])));
  QToolTip::showText(help->globalPos(), text, this);
  return true;
}

void HalfDifferenceChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), PlotStyle::of(palette()).background);
  drawShading(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  drawAxes(painter);
  drawSamples(painter);
  drawColourBar(painter);
  drawLegend(painter);
  drawHint(painter, plot());
  drawFocus(painter);
}

}  // namespace gonio::widgets

#include "moc_half_difference_chart.cpp"
