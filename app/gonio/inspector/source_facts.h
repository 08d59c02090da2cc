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
/// @param tableSnr error of the material's table if it is sampled, dB. @param measuring whether the error is being
/// measured.
std::vector<widgets::Fact> sourceFacts(const LoadedMaterial& material, std::optional<double> tableSnr, bool measuring);
/// The error of a fit, in one or two lines.
QString fitSummary(const fitting::FitResult& fit);

}  // namespace gonio::app
