// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QByteArray>
#include <QSize>
#include <QString>

namespace gonio::widgets {

class Plot;

/// A plot as content of a file, dark on white in every theme: SVG 1.2 Tiny, or PNG with twice the size in pixels.
/// @param size in the units of the widget; empty: that of the widget, 480 x 320 at least.
QByteArray plotAsSvg(Plot& plot, const QSize& size = {});
QByteArray plotAsPng(Plot& plot, const QSize& size = {});
QByteArray plotAsCsv(const Plot& plot);

/// Writes the plot atomically, in the format of the path's suffix (.svg, .png, .csv).
/// @throws Error that names the file, if the file cannot be written or the suffix is none of these.
void exportPlot(Plot& plot, const QString& path, const QSize& size = {});

}  // namespace gonio::widgets
