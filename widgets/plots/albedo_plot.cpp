// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/plots/albedo_plot.h"

#include "widgets/plots/plot_text.h"

namespace gonio::widgets {

AlbedoPlot::AlbedoPlot(QWidget* parent) : CurveChart(tr("Albedo"), parent) {
  setAccessibleDescription(
      tr("Directional albedo vs. the polar angle of the viewer; above 1 a material gains energy."));
}

ChartAxes AlbedoPlot::axes() const {
  const QString channel = channelName(settings().channel);
  return {
      tr("θo [°] of the viewer"),
      tr("%1 of ∫ ρ cos θi dωi").arg(channel),
      0,
      90,
      "theta_o",
      "no unit",
      QString(),
      channelForCsv(settings().channel) + " of the integral of rho cos theta_i over the light's hemisphere, no unit"};
}

}  // namespace gonio::widgets

#include "moc_albedo_plot.cpp"
