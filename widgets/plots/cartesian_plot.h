// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/plots/curve_chart.h"

namespace gonio::widgets {

/// Values over theta_h, theta_d or theta_o. The other angles are fixed, and stated in the title of the axis.
class CartesianPlot final : public CurveChart {
  Q_OBJECT

 public:
  explicit CartesianPlot(QWidget* parent = nullptr);

  /// @param section the section to which the curves belong.
  void setSection(const plots::Section& section, PlotSeriesList<plots::Curve> series);

 protected:
  ChartAxes axes() const override;
  std::optional<double> incidence() const override;
  std::vector<std::string> fixedForCsv() const override;

 private:
  plots::Section m_section;
};

}  // namespace gonio::widgets
