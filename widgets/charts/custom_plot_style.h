// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QFont>
#include <QSize>

#include "widgets/charts/plot_style.h"

class QCustomPlot;
class QCPAxis;
class QPaintDevice;

namespace gonio::widgets {

/// Colours and fonts of a chart, its axes and its legend.
void styleChart(QCustomPlot& chart, const PlotStyle& style, const QFont& font);
void styleAxis(QCPAxis& axis, const PlotStyle& style, const QFont& font);
/// Sets the scale of an axis and its ticks: powers of ten on a logarithmic axis.
void setLogarithmic(QCPAxis& axis, bool logarithmic);
/// Draws a chart at any size on any device, as vector graphics. Graphs are clipped to their axes beforehand, because
/// SVG Tiny files do not clip.
void paintChart(QCustomPlot& chart, QPaintDevice& device, const QSize& size);

}  // namespace gonio::widgets
