// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

namespace gonio::factorization {

/// Blends decreasing curves by their widths: at each fraction of the height, the width of the result is the weighted
/// geometric mean of the curves' widths. Thus g(x / a) and g(x / b) with the weights 1 - t and t give g(x / (a^(1 - t)
/// b^t)), while a mean of the values would have a narrow peak on a wide base. Where a curve is not decreasing, its
/// difference from the smallest decreasing curve above it is blended as a mean of values. Zero curves are ignored;
/// equal curves give themselves. Heights are normalised to 1. @param nodes strictly increasing from 0. @param curves
/// values >= 0 at the nodes, one curve per weight. @param weights >= 0. Returns 0 everywhere if all curves with a
/// weight > 0 are 0.
std::vector<double> blendedByWidth(std::span<const double> nodes, std::span<const std::vector<double>> curves,
                                   std::span<const double> weights);

}  // namespace gonio::factorization
