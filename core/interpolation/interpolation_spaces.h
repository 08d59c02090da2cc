// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/interpolation/interpolation.h"

namespace gonio::interpolation {

/// The implementations of prepareInterpolation(), one for each space.

std::shared_ptr<const Interpolation> prepareLinear(std::span<const InterpolationMaterial> ends,
                                                   const TaskControl& control);
/// The space `differential` or `parameters`.
std::shared_ptr<const Interpolation> prepareParametric(std::span<const InterpolationMaterial> ends, bool isDifferential,
                                                       const InterpolationOptions& options, const TaskControl& control);
std::shared_ptr<const Interpolation> prepareFactors(std::span<const InterpolationMaterial> ends,
                                                    const InterpolationOptions& options, const TaskControl& control);
std::shared_ptr<const Interpolation> prepareDictionary(std::span<const InterpolationMaterial> ends,
                                                       const InterpolationOptions& options, const TaskControl& control);

/// The mixture of tables of untransformed BRDF values (DataTransform::none).
std::shared_ptr<const TransformedMixture> mixtureOf(const std::vector<Interpolation::Table>& tables);
/// The table of each material.
std::vector<Interpolation::Table> tablesOf(std::span<const InterpolationMaterial> ends);
/// The tables resampled on the grid of the first. @throws Cancelled.
std::vector<Interpolation::Table> onOneGrid(const std::vector<Interpolation::Table>& tables,
                                            const TaskControl& control);

}  // namespace gonio::interpolation
