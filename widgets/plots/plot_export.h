// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QByteArray>
#include <QString>

namespace gonio::widgets {

class Plot;

/// A plot as a file's content, dark on white whatever the theme: SVG 1.2 Tiny, PNG at twice the size of the widget.
QByteArray plotAsSvg(Plot& plot);
QByteArray plotAsPng(Plot& plot);
QByteArray plotAsCsv(const Plot& plot);

/// Writes what the suffix of the path says (.svg, .png, .csv), atomically.
/// @throws Error naming the file: the system's reason, or a suffix that is none of these.
void exportPlot(Plot& plot, const QString& path);

}  // namespace gonio::widgets
