// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QObject>
#include <vector>

#include "app/gonio/document/background_task.h"
#include "core/figures/figure_measurement.h"

namespace gonio::app {

/// The page of a figure for display.
struct DrawnFigure {
  QImage page;
  std::vector<QRectF> pictures;  ///< their positions, in fractions of the page
  std::size_t cells = 0, missing = 0;
  double errorMaximum = 0;
};

/// Measures and draws a figure in the background. Each change of the description updates the page immediately; cells
/// that are not measured are grey until measure(). Results are reused if the new description needs them.
class FigureController : public QObject {
  Q_OBJECT

 public:
  explicit FigureController(BackgroundTasks& tasks, QObject* parent = nullptr);
  ~FigureController() override;

  const figures::FigureDescription& description() const { return m_description; }
  void setDescription(const figures::FigureDescription& description);
  /// Sets the width of the page in pixels.
  void setPageWidth(int pixels);
  /// Measures the missing cells.
  void measure();
  void cancel();
  bool isMeasuring() const;
  /// Progress of the measurement in [0, 1]; nullopt if none is running.
  std::optional<double> progress() const;
  bool isDrawing() const;
  const figures::FigureMeasurement& known() const { return m_known; }
  /// A callback for other measurements in the background, which passes their results to this figure. The callback may
  /// be called from any thread.
  std::function<void(const figures::FigureMeasurement&)> collector();

 Q_SIGNALS:
  void drawn(const gonio::app::DrawnFigure& figure);
  /// The page cannot be drawn.
  void refused(const QString& reason);
  /// isMeasuring() or progress() may have changed.
  void progressed();
  /// The measurement ended with an error.
  void failed(const QString& text);

 private:
  void draw();

  BackgroundTasks& m_tasks;
  const QString m_drawKey, m_measureKey;
  figures::FigureDescription m_description;
  figures::FigureMeasurement m_known;
  int m_pageWidth = 0;
};

}  // namespace gonio::app
