// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFont>
#include <QSize>

// QCustomPlot's header is written with Qt's short keywords, which this project switches off.
#define signals Q_SIGNALS
#define slots Q_SLOTS
#define foreach Q_FOREACH
#include <qcustomplot.h>
#undef signals
#undef slots
#undef foreach

#include "widgets/charts/plot_style.h"

class QLabel;

namespace gonio::widgets {

/// Colours and fonts of a chart, its axes and its legend.
void styleChart(QCustomPlot& chart, const PlotStyle& style, const QFont& font);
void styleAxis(QCPAxis& axis, const PlotStyle& style, const QFont& font);
/// Fills a widget with a chart that has a box of axes. @return the text in its middle for what is to be done while it
/// is empty.
QLabel* addHint(QWidget& widget, QCustomPlot& chart);
/// Sets the scale of an axis and its ticks: powers of ten on a logarithmic axis.
void setLogarithmic(QCPAxis& axis, bool logarithmic);
/// Draws a chart at any size on any device, as vector graphics. Graphs are clipped to their axes beforehand, because
/// SVG Tiny files do not clip.
void paintChart(QCustomPlot& chart, QPaintDevice& device, const QSize& size);

}  // namespace gonio::widgets
