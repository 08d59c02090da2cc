// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QBrush>
#include <QString>
#include <cstdint>

#include "widgets/charts/plot_style.h"

namespace gonio::widgets {

/// State of a cell of the grid.
enum class CellState : std::uint8_t {
  measurable,
  belowHorizon,  ///< light or viewer is below the horizon
  grazing,       ///< beyond the maximum polar angle
  forbidden,     ///< in a forbidden region of the rig
  unlearned      ///< invalid in at least one material of the training set
};

/// The shaded states, in the order of the legend.
inline constexpr CellState shadedStates[] = {CellState::belowHorizon, CellState::grazing, CellState::forbidden,
                                             CellState::unlearned};

/// "beyond the max. polar angle"
QString stateName(CellState state);
/// Shading of cells, distinguishable by the hatching.
QBrush stateBrush(CellState state, const PlotStyle& style);

}  // namespace gonio::widgets
