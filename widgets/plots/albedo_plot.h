// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/plots/curve_chart.h"

namespace gonio::widgets {

/// Directional albedo against the polar angle: the fraction of light from one direction that is reflected or, by
/// reciprocity, the fraction of uniform light that reaches a viewer. Above the line at 1 a material would reflect more
/// energy than it receives.
class AlbedoPlot final : public CurveChart {
  Q_OBJECT

 public:
  explicit AlbedoPlot(QWidget* parent = nullptr);

 protected:
  ChartAxes axes() const override;
  std::optional<double> incidence() const override { return degrees(settings().thetaI); }
  std::optional<double> limit() const override { return 1; }
};

}  // namespace gonio::widgets
