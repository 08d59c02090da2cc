// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/curves/curve_legend.h"

#include <QPainter>

#include "widgets/curves/curve_view.h"

namespace gonio::widgets {

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

#include "moc_curve_legend.cpp"
