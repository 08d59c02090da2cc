// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/brdf/tabulated_brdf.h"

/// No models: what a model cannot keep before anything is factorised.
namespace gonio::study {

/// The mean of a measurement and its mirror image in the plane of incidence: no model that is symmetric about that
/// plane, as all in the comparison are, comes closer to the measurement in the mean square of reflectances.
std::shared_ptr<const Brdf> symmetricMean(std::shared_ptr<const TabulatedBrdf> table);

/// The measurement at the nodes of the three-factor PDV model, trilinear in ln(1 + rho) between those that have one:
/// what the grid alone costs.
std::shared_ptr<const Brdf> deviationGrid(const std::shared_ptr<const TabulatedBrdf>& table);

}  // namespace gonio::study
