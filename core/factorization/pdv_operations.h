// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/factorization/pdv_factors.h"

/// What is done with factors to edit a material: each operation is a function of values. Curves live in the transformed
/// domain: a curve scaled by 2 has twice the ln(1 + rho), not twice the rho.
///
/// The first term of a model is the material's mirror-like appearance; the terms behind it describe what this material
/// has besides. They fit no other curves, so an operation that takes a curve from another material drops them, unless
/// it is asked to keep them. One that moves |Dp| moves all terms.
namespace gonio::factorization {

// Curves: the values at nodes.

/// The curve at other nodes: monotone cubic between its own nodes, held beyond them.
std::vector<double> resampled(std::span<const double> nodes, std::span<const double> curve,
                              std::span<const double> newNodes);
/// The curve stretched about 0 by a factor > 0: value at x is that at x / factor.
std::vector<double> widened(std::span<const double> nodes, std::span<const double> curve, double factor);
/// All values times a factor.
std::vector<double> scaled(std::span<const double> curve, double factor);
/// Turned about the middle of the nodes' range: values times 1 + amount * t, t running from -1 at the first node to 1
/// at the last. |amount| <= 1 keeps all signs.
std::vector<double> tilted(std::span<const double> nodes, std::span<const double> curve, double amount);
/// Weighted means of neighbouring nodes: a Gaussian over the nodes' indices, of a standard deviation of `radius` nodes,
/// cut at three of them and renormalised at the ends. Constants stay, no value leaves the range; radius 0 changes none.
std::vector<double> smoothed(std::span<const double> curve, double radius);

// Models.

enum class FurtherTerms { drop, keep };

/// The target with the first term's F1 of another material, in each channel: how strongly it mirrors at each angle.
/// @throws Error when the transforms differ.
PdvFactors takeF1(const PdvFactors& target, const PdvFactors& other, FurtherTerms terms = FurtherTerms::drop);
/// The same of F2: how wide its highlight is. Exact where both have the same nodes of |Dp| (PdvOptions); else
/// resampled.
PdvFactors takeF2(const PdvFactors& target, const PdvFactors& other, FurtherTerms terms = FurtherTerms::drop);

/// The highlight becomes wider by a factor (narrower below 1): F2 of all terms stretched over |Dp|, on the same nodes.
/// @throws Error when the factor is not a positive number.
PdvFactors widenF2(const PdvFactors& target, double factor);

/// The model with `highest` raised to what its terms can reach now: call it when curves have grown by editing.
PdvFactors withRoomForEdits(const PdvFactors& factors);

}  // namespace gonio::factorization
