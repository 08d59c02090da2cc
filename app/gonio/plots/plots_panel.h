// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QTimer>
#include <QWidget>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "app/gonio/plots/plot_controls.h"

class QSettings;
class QStackedWidget;

namespace gonio::widgets {
class AlbedoPlot;
class CartesianPlot;
class LobePlot;
class Plot;
class PolarPlot;
class SlicePlot;
}  // namespace gonio::widgets

namespace gonio::app {

/// The content of the Plots dock: the document's measurement, fit and edit in five plots with common settings. The data
/// are computed in the background, only for the shown plot and only while the panel is visible. While a slider moves,
/// each computation is finished and shown before the next one starts with the newest state.
class PlotsPanel : public QWidget {
  Q_OBJECT

 public:
  PlotsPanel(Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);

  /// Raises the dock and shows a plot at an angle of incidence (rad).
  void showAt(PlotKind kind, double thetaI);
  /// The same by name ("polar", "cartesian", "slice", "albedo", "lobe"), at the current angle.
  void showKind(const QString& name);
  /// Sets further fits of the document's material that are plotted.
  void setOtherFits(const std::vector<PlottedFit>& fits);
  /// Sets the angle of incidence of all plots (rad), clamped to their range.
  void setThetaI(double thetaI) { m_controls->setThetaI(thetaI); }
  PlotControls& controls() { return *m_controls; }
  widgets::Plot& currentPlot() const;
  /// Whether the shown plot belongs to the document's current state, or the panel is hidden.
  bool isSettled() const;

  void saveState(QSettings& settings) const { m_controls->saveState(settings); }
  void restoreState(const QSettings& settings) { m_controls->restoreState(settings); }

 Q_SIGNALS:
  /// The user wants to pick the angle on the preview.
  void pickingToggled(bool picking);
  void exported(const QString& path);
  void failed(const QString& title, const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;
  QSize sizeHint() const override;

 private:
  void addPlots();
  void choicesChanged();
  void documentChanged();
  void request();
  void start();
  void finished(const PlotRequest& request, const PlotData& plotted);
  void clear();

  Document& m_document;
  BackgroundTasks& m_tasks;
  PlotControls* m_controls;
  QStackedWidget* m_stack;
  widgets::PolarPlot* m_polar;
  widgets::CartesianPlot* m_cartesian;
  widgets::SlicePlot* m_slice;
  widgets::AlbedoPlot* m_albedo;
  widgets::LobePlot* m_lobe;
  QList<widgets::Plot*> m_plots;  ///< in the order of PlotKind
  std::vector<PlottedFit> m_otherFits;
  std::shared_ptr<const KnownAlbedo> m_known;
  QTimer m_rest;  ///< runs during an interaction; at timeout the albedo is refined
  bool m_running = false, m_again = false;
};

}  // namespace gonio::app
