// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QBrush>
#include <QString>
#include <cstdint>

#include "widgets/charts/plot_style.h"

namespace gonio::widgets {

/// What can be said of a cell of the grid.
enum class CellState : std::uint8_t {
  measurable,
  belowHorizon,  ///< of light or viewer
  grazing,       ///< beyond the largest polar angle
  forbidden,     ///< the rig cannot reach it
  unlearned      ///< not valid in every material of the training set
};

/// Those that are shaded, in the order of their legend.
inline constexpr CellState shadedStates[] = {CellState::belowHorizon, CellState::grazing, CellState::forbidden,
                                             CellState::unlearned};

/// "grazing"
QString stateName(CellState state);
/// How cells are shaded: distinguished by their hatching.
QBrush stateBrush(CellState state, const PlotStyle& style);

}  // namespace gonio::widgets
