// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/plots/slice.h"
#include "widgets/charts/custom_plot.h"

/// The parts of a slice's chart that need no widget.
namespace gonio::widgets {

/// core/rendering/false_colour.h's map for QCustomPlot; cells without a number are left out.
QCPColorGradient viridisGradient();
/// One colour for every number.
QCPColorGradient plainGradient(const QColor& colour);
/// Degrees of theta_h on an axis of shares.
QSharedPointer<QCPAxisTicker> thetaHTicker(plots::ThetaHSpacing spacing);
QSharedPointer<QCPAxisTicker> thetaDTicker();

}  // namespace gonio::widgets
