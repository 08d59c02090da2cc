// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QByteArray>
#include <QSize>
#include <QString>

namespace gonio::widgets {

class Plot;

/// A plot as a file's content, dark on white whatever the theme: SVG 1.2 Tiny, PNG of twice as many pixels.
/// @param size in the units of the widget; empty: that of the widget, 480 x 320 at least.
QByteArray plotAsSvg(Plot& plot, const QSize& size = {});
QByteArray plotAsPng(Plot& plot, const QSize& size = {});
QByteArray plotAsCsv(const Plot& plot);

/// Writes what the suffix of the path says (.svg, .png, .csv), atomically.
/// @throws Error naming the file: the system's reason, or a suffix that is none of these.
void exportPlot(Plot& plot, const QString& path, const QSize& size = {});

}  // namespace gonio::widgets
