// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <vector>

#include "app/gonio/document/loaded_material.h"
#include "core/fitting/fit.h"
#include "widgets/panels/fact_list.h"

namespace gonio::app {

/// What the source section shows of a material: file, hash, grid, range of values, invalid fraction, albedo.
/// @param tableSnr the error of the material's table where it is sampled, dB. @param measuring whether it is on its
/// way.
std::vector<widgets::Fact> sourceFacts(const LoadedMaterial& material, std::optional<double> tableSnr, bool measuring);
/// The residual of a fit in one or two lines.
QString fitSummary(const fitting::FitResult& fit);

}  // namespace gonio::app
