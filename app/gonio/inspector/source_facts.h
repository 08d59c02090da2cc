// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <vector>

#include "app/gonio/document/loaded_material.h"
#include "core/fitting/fit.h"
#include "widgets/panels/fact_list.h"

namespace gonio::app {

/// The facts of the Source section: file, hash, grid, range of values, fraction of invalid cells, albedo.
/// @param tableSnr rendered SNR of the table against the native form if the table is sampled, dB. @param measuring
/// whether it is being measured.
std::vector<widgets::Fact> sourceFacts(const LoadedMaterial& material, std::optional<double> tableSnr, bool measuring);
/// Up to two errors of a fit, its time and its number of cells, in one line.
QString fitSummary(const fitting::FitResult& fit);

}  // namespace gonio::app
