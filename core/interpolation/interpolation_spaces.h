// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/interpolation/interpolation.h"

/// What prepareInterpolation() chooses from, one per file.
namespace gonio::editing {

std::shared_ptr<const Interpolation> prepareLinear(std::span<const InterpolationEnd> ends, const TaskControl& control);
/// `parameters`, or `differential` where the measured detail is kept.
std::shared_ptr<const Interpolation> prepareParametric(std::span<const InterpolationEnd> ends, bool keepDetail,
                                                       const InterpolationOptions& options, const TaskControl& control);
std::shared_ptr<const Interpolation> prepareFactors(std::span<const InterpolationEnd> ends,
                                                    const InterpolationOptions& options, const TaskControl& control);
std::shared_ptr<const Interpolation> prepareDictionary(std::span<const InterpolationEnd> ends,
                                                       const InterpolationOptions& options, const TaskControl& control);

/// The tables as they are, untransformed.
TransformedMixture mixtureOf(const std::vector<Interpolation::Table>& tables);
/// The ends' own tables.
std::vector<Interpolation::Table> tablesOf(std::span<const InterpolationEnd> ends);
/// The ends' tables on the grid of the first. @throws Cancelled.
std::vector<Interpolation::Table> onOneGrid(const std::vector<Interpolation::Table>& tables,
                                            const TaskControl& control);

}  // namespace gonio::editing
