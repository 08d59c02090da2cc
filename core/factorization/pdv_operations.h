// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/factorization/pdv_factors.h"

/// Operations on factors for editing a material; all return new values. Curves are in the transformed domain: with
/// DataTransform::logPlus, scaling a curve by 2 doubles ln(1 + rho), not rho.
///
/// The first term of a model describes the highlight; further terms correct it for this material and are valid
/// only together with its own curves, so operations that replace a curve by that of another material drop the further
/// terms by default. Operations that stretch |Dp| change all terms.
namespace gonio::factorization {

// Curves: values at nodes.

/// The curve at other nodes: monotone cubic between its own nodes, constant beyond them.
std::vector<double> resampled(std::span<const double> nodes, std::span<const double> curve,
                              std::span<const double> newNodes);
/// The curve stretched about 0 by a factor > 0: its value at x is the old value at x / factor.
std::vector<double> widened(std::span<const double> nodes, std::span<const double> curve, double factor);
/// The curve multiplied by a factor.
std::vector<double> scaled(std::span<const double> curve, double factor);
/// The curve multiplied by 1 + amount * t, where t rises linearly from -1 at the first node to 1 at the last. |amount|
/// <= 1 preserves signs.
std::vector<double> tilted(std::span<const double> nodes, std::span<const double> curve, double amount);
/// The curve smoothed by a Gaussian over the nodes' indices with standard deviation `radius`, cut off at three standard
/// deviations and renormalised at the ends. Constants are preserved, and no value leaves the range. Radius 0 has no
/// effect.
std::vector<double> smoothed(std::span<const double> curve, double radius);

// Models.

enum class FurtherTerms { drop, preserve };

/// The target with F1 (specular strength vs. angle) of another material's first term, per channel. @throws Error if the
/// transforms differ.
PdvFactors withF1Of(const PdvFactors& target, const PdvFactors& other, FurtherTerms terms = FurtherTerms::drop);
/// The target with F2 (highlight profile) of another material's first term. Exact if both have the same nodes of |Dp|
/// (PdvOptions); otherwise resampled.
PdvFactors withF2Of(const PdvFactors& target, const PdvFactors& other, FurtherTerms terms = FurtherTerms::drop);

/// Widens the highlight by a factor (below 1: narrows it): F2 of all terms stretched along |Dp|, on the same nodes.
/// @throws Error if the factor is not a positive number.
PdvFactors widenF2(const PdvFactors& target, double factor);

/// Evaluation limits values of curves to this size: products of three and sums of terms are then finite in single
/// precision.
inline constexpr double maxCurveValue = 1e30;
/// A clause for the user if values of curves are larger than maxCurveValue; empty otherwise.
std::string curveLimitWarning(const PdvFactors& factors);

/// The model with the upper bound `highest` raised to the maximum that its terms can reach, at most maxCurveValue, and
/// `lowest` lowered in the same ratio. Call it after edits that raise curves.
PdvFactors withRoomForEdits(const PdvFactors& factors);

}  // namespace gonio::factorization
