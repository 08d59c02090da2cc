// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/plots/plotted_values.h"
#include "widgets/charts/custom_plot.h"

/// Parts of a slice chart that need no widget.
namespace gonio::widgets {

/// The colour map of core/rendering/error_maps.h for QCustomPlot; cells with NaN stay transparent.
QCPColorGradient viridisGradient();
/// One colour for all numbers.
QCPColorGradient plainGradient(const QColor& colour);
/// Labels in degrees of theta_h on an axis of fractions (plots::thetaHFraction()).
QSharedPointer<QCPAxisTicker> thetaHTicker(plots::ThetaHSpacing spacing);
QSharedPointer<QCPAxisTicker> thetaDTicker();

}  // namespace gonio::widgets
