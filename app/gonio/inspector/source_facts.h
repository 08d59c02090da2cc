// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <vector>

#include "app/gonio/document/loaded_material.h"
#include "app/gonio/inspector/monitors.h"
#include "core/fitting/fit.h"
#include "widgets/panels/fact_list.h"

namespace gonio::app {

/// The facts of the Source section: file, hash, grid, range of values, fraction of invalid cells, albedo.
/// @param tableSnr rendered SNR of the table against the native form if the table is sampled, dB. @param measuring
/// whether it is being measured.
std::vector<widgets::Fact> sourceFacts(const LoadedMaterial& material, std::optional<double> tableSnr, bool measuring);
/// One line: how close the fit is and what it costs, "Match: close; 5.2 ms a frame; 84 bytes".
QString costLine(const CostMonitor::Costs& costs);
/// All numbers of the line, one per line. @param fit of the active edit; null: read from a document, or none.
QString costDetails(const CostMonitor::Costs& costs, const fitting::FitResult* fit);

}  // namespace gonio::app
