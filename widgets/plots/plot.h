// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QByteArray>
#include <QSize>
#include <QString>
#include <QWidget>

#include "core/io/csv_text.h"
#include "widgets/charts/plot_style.h"
#include "widgets/plots/plot_series.h"

class QLabel;

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

/// Base of the plots: settings, a readout of the value under the pointer, an empty state, and a menu to reset the view
/// and to export. Left and right arrow keys change the angle of incidence (Shift: by a tenth), Home and double-click
/// reset the view.
class Plot : public QWidget {
  Q_OBJECT

 public:
  explicit Plot(const QString& title, QWidget* parent = nullptr);

  const QString& title() const { return m_title; }
  const PlotSettings& settings() const { return m_settings; }
  void setSettings(const PlotSettings& settings);
  /// Name of the material, for exported files.
  void setSource(const QString& source) { m_source = source; }
  const QString& source() const { return m_source; }
  /// Text shown in place of the plot if there are no series.
  void setHint(const QString& hint);

  /// Draws the complete plot on any device, e.g. a picture or an SVG file.
  virtual void drawOn(QPaintDevice& device, const QSize& size, const PlotStyle& style) = 0;
  /// The plotted numbers, with a header that describes them.
  virtual io::CsvTable table() const = 0;
  virtual bool isEmpty() const = 0;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 public Q_SLOTS:
  virtual void resetView() = 0;
  /// Asks for a name and writes the plot; `suffix` is "svg", "png" or "csv".
  /// @param size of a picture, in the units of the widget; empty: as it is shown.
  void exportAs(const QString& suffix, const QSize& size = {});

 Q_SIGNALS:
  /// The user changed the angle of incidence (rad, [0, maxThetaI]). The plot itself does not change until
  /// setSettings().
  void thetaIEdited(double thetaI);
  void exported(const QString& path);
  void failed(const QString& title, const QString& text);

 protected:
  /// Redraws the plot after a change of settings or series.
  virtual void refresh() = 0;
  /// The first header lines of every table: quantity, material, values, convention.
  std::vector<std::string> commentsOfTable() const;
  PlotStyle style() const { return PlotStyle::of(palette()); }
  /// Shows a text beside the pointer; an empty text hides it.
  void showReadout(const QString& text, const QPointF& pointer = {});
  /// Shows the hint if isEmpty(), else hides it.
  void showEmptiness();
  void editThetaI(double thetaI);

  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  /// The background.
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  QString m_title, m_source;
  PlotSettings m_settings;
  QLabel *m_readout, *m_hint;
};

}  // namespace gonio::widgets
