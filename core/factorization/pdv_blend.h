// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

#include "core/factorization/pdv_factors.h"

namespace gonio::factorization {

/// Which blend of factors.
enum class BlendForm {
  published,  ///< at most maxPdvTerms terms; a curve is nowhere wider than its last node
  /// Continuous in the weights, also where one reaches 1: contains all terms, and below its value at the last node a
  /// curve is as wide as if it fell to 0, linearly, at twice the distance of this node.
  continuous
};

/// Blends decreasing curves by their widths: at each fraction of the height, the width of the result is the weighted
/// geometric mean of the curves' widths. Thus g(x / a) and g(x / b) with the weights 1 - t and t give g(x / (a^(1 - t)
/// b^t)), while a mean of the values would have a narrow peak on a wide base. Where a curve is not decreasing, its
/// difference from the smallest decreasing curve above it is blended as a mean of values. Zero curves are ignored;
/// equal curves give themselves. Heights are normalised to 1. @param nodes strictly increasing from 0. @param curves
/// values >= 0 at the nodes, one curve per weight. @param weights >= 0. Returns 0 everywhere if all curves with a
/// weight > 0 are 0.
std::vector<double> blendedByWidth(std::span<const double> nodes, std::span<const std::vector<double>> curves,
                                   std::span<const double> weights, BlendForm form = BlendForm::published);

/// @throws Error if transforms or forms differ, so that the factors cannot be blended.
void checkBlendable(std::span<const PdvFactors* const> ends);

/// The curves of `factors` at the nodes of others: resampled where the nodes differ. @throws Error as checkBlendable().
PdvFactors atNodesOf(const PdvFactors& nodes, const PdvFactors& factors);

/// Blends factors of materials. The first term, which describes the highlight, is blended curve by curve on the nodes
/// of the first material (others are resampled): F2 by its width (core/factorization/pdv_blend.h), so that a narrow
/// and a wide highlight give one of intermediate width; F1 and F3 as weighted means. Further terms are corrections to
/// the first term of their own material and may cancel one another, so their curves are not mixed but only scaled by
/// the weight of the material. With BlendForm::published the result has at most maxPdvTerms terms; those of higher
/// index are dropped. @param ends factors of the materials, one per weight, at least one. @param weights >= 0, sum 1.
/// Factors of weight 1 are returned unchanged. @throws Error as checkBlendable().
PdvFactors blended(std::span<const PdvFactors* const> ends, std::span<const double> weights,
                   BlendForm form = BlendForm::published);

}  // namespace gonio::factorization
