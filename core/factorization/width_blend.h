// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>
#include <vector>

namespace gonio::factorization {

/// The curve between falling curves, by their widths: at each fraction of its height it is as wide as the geometric
/// mean of theirs, weighted. So between g(x / a) and g(x / b) lies g(x / (a^(1 - t) b^t)), where a mean of the values
/// would be narrow and wide at once. Where a curve rises again, what it has less than its falling hull is a mean of
/// values. Curves of 0 throughout have no width and do not count; equal curves give themselves.
/// @param nodes from 0, strictly increasing; @param curves one a weight, >= 0, at these nodes; @param weights >= 0, one
/// of a curve other than 0 above 0, else the result is 0. The heights are normalised to 1, as is the result's.
std::vector<double> blendedByWidth(std::span<const double> nodes, std::span<const std::vector<double>> curves,
                                   std::span<const double> weights);

}  // namespace gonio::factorization
