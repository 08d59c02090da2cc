// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QApplication>
#include <QLabel>
#include <QTest>

#include "core/plots/plotted_values.h"
#include "tests/support/function_brdf.h"
#include "widgets/plots/curve_chart.h"
#include "widgets/plots/lobe_plot.h"
#include "widgets/plots/polar_plot.h"
#include "widgets/plots/slice_plot.h"

/// Plots of known curves, and the mouse on them.
namespace gonio::widgets::test_support {

using plots::CosineFactor;

inline const PlotSettings settings{.cosine = CosineFactor::outgoing, .thetaI = radians(30)};

/// Lambert of reflectance 1 and 0.5, times cos theta_o.
template <class Compute>
inline auto twoSeries(Compute compute) {
  PlotSeriesList<decltype(compute(test::lambert(Rgb(1))))> list;
  list.push_back({SeriesRole::measured, "measured", compute(test::lambert(Rgb(1)))});
  list.push_back({SeriesRole::edited, "edited", compute(test::lambert(Rgb(0.5)))});
  return list;
}
inline plots::Curve lobeCurve(const Brdf& brdf) { return plots::polarLobe(brdf, settings.thetaI, settings.cosine); }

/// Shown with data and settings; the offscreen platform lays it out.
template <class AnyPlot>
std::unique_ptr<AnyPlot> shown(std::unique_ptr<AnyPlot> plot) {
  plot->setSource("chalk");
  plot->setSettings(settings);
  plot->resize(600, 320);
  plot->show();
  QTest::qWait(20);
  return plot;
}
inline std::unique_ptr<PolarPlot> polarPlot() {
  auto plot = std::make_unique<PolarPlot>();
  plot->setSeries(twoSeries(lobeCurve));
  return shown(std::move(plot));
}
inline std::unique_ptr<CartesianPlot> cartesianPlot(plots::SectionAxis axis = plots::SectionAxis::thetaO) {
  const plots::Section section{
      .axis = axis, .thetaI = settings.thetaI, .thetaD = radians(20), .cosine = settings.cosine};
  auto plot = std::make_unique<CartesianPlot>();
  plot->setSection(section, twoSeries([&](const Brdf& brdf) { return plots::sectionCurve(brdf, section); }));
  return shown(std::move(plot));
}
inline std::unique_ptr<SlicePlot> slicePlot() {
  auto plot = std::make_unique<SlicePlot>();
  plot->setSeries(twoSeries([](const Brdf& brdf) {
    return plots::sliceOf(brdf, plots::SliceCoordinates::halfDifference, 0.3, plots::ThetaHSpacing::squareRoot,
                          settings.cosine);
  }));
  return shown(std::move(plot));
}
inline std::unique_ptr<AlbedoPlot> albedoPlot() {
  auto plot = std::make_unique<AlbedoPlot>();
  plot->setSeries(twoSeries([](const Brdf& brdf) { return plots::albedoCurve(brdf, 5, 64); }));
  return shown(std::move(plot));
}
inline std::unique_ptr<LobePlot> lobePlot() {
  auto plot = std::make_unique<LobePlot>();
  plot->setSeries(
      twoSeries([](const Brdf& brdf) { return plots::lobeSurface(brdf, settings.thetaI, settings.cosine); }));
  return shown(std::move(plot));
}

inline std::vector<std::unique_ptr<Plot>> allPlots() {
  std::vector<std::unique_ptr<Plot>> all;
  all.push_back(polarPlot());
  all.push_back(cartesianPlot());
  all.push_back(slicePlot());
  all.push_back(albedoPlot());
  all.push_back(lobePlot());
  return all;
}

/// The widget that gets the mouse: a chart inside the plot, or the plot itself.
inline QWidget* target(Plot& plot) {
  for (QWidget* child : plot.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
    if (!qobject_cast<QLabel*>(child)) return child;
  return &plot;
}
inline void moveTo(Plot& plot, const QPointF& position, Qt::MouseButtons buttons) {
  QWidget* widget = target(plot);
  QMouseEvent event(QEvent::MouseMove, position, widget->mapToGlobal(position), Qt::NoButton, buttons, Qt::NoModifier);
  QApplication::sendEvent(widget, &event);
}
inline void drag(Plot& plot, const QPointF& from, const QPointF& to) {
  QTest::mousePress(target(plot), Qt::LeftButton, {}, from.toPoint());
  moveTo(plot, to, Qt::LeftButton);
  QTest::mouseRelease(target(plot), Qt::LeftButton, {}, to.toPoint());
}
inline QString readout(Plot& plot) {
  for (const QLabel* label : plot.findChildren<QLabel*>())
    if (label->isVisible() && label->autoFillBackground()) return label->text();
  return {};
}

}  // namespace gonio::widgets::test_support
