// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/plots/plot_export.h"

#include <QBuffer>
#include <QImage>
#include <QSvgGenerator>
#include <filesystem>

#include "core/io/atomic_file.h"
#include "core/io/csv_table.h"
#include "core/support/error.h"
#include "widgets/plots/plot.h"

namespace gonio::widgets {

namespace {
namespace fs = std::filesystem;
constexpr double pngScale = 2;
constexpr QSize smallest(480, 320);
QSize exportSize(const Plot& plot, const QSize& size) {
  return size.isEmpty() ? plot.size().expandedTo(smallest) : size;
}
}  // namespace

QByteArray plotAsSvg(Plot& plot, const QSize& wanted) {
  const QSize size = exportSize(plot, wanted);
  QBuffer buffer;
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setSize(size);
  generator.setViewBox(QRect(QPoint(0, 0), size));
  generator.setResolution(plot.logicalDpiX());
  generator.setTitle(plot.title());
  generator.setDescription(plot.source());
  plot.drawOn(generator, size, PlotStyle::paper());
  return buffer.data();
}

QByteArray plotAsPng(Plot& plot, const QSize& wanted) {
  const QSize size = exportSize(plot, wanted);
  QImage image(size * pngScale, QImage::Format_RGB32);
  image.setDevicePixelRatio(pngScale);
  image.fill(Qt::white);
  plot.drawOn(image, size, PlotStyle::paper());
  QBuffer buffer;
  image.save(&buffer, "PNG");
  return buffer.data();
}

QByteArray plotAsCsv(const Plot& plot) { return QByteArray::fromStdString(io::toCsv(plot.table())); }

void exportPlot(Plot& plot, const QString& path, const QSize& size) {
  QByteArray content;
  if (path.endsWith(QStringLiteral(".svg"), Qt::CaseInsensitive))
    content = plotAsSvg(plot, size);
  else if (path.endsWith(QStringLiteral(".png"), Qt::CaseInsensitive))
    content = plotAsPng(plot, size);
  else if (path.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive))
    content = plotAsCsv(plot);
  else
    throw Error(path.toStdString() + ": found the suffix '" + fs::path(path.toStdString()).extension().string() +
                "', expected .svg, .png or .csv");
  io::writeFileAtomically(path.toStdString(), content.toStdString());
}

}  // namespace gonio::widgets
