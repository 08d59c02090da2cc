// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/interpolation/interpolation.h"

namespace gonio::interpolation {

/// Blends that preserve the measured detail of the materials. With m_i the materials, w_i their weights, c_i their
/// fits, factors or codes, and D the BRDF of these:
///   blend = sum w_i m_i + change,  change = D(blend of the c_i) - sum w_i D(c_i).
/// Each material thus adds m_i - D(c_i), the detail that its representation misses, by its weight, and at a weight of 1
/// the change is 0. The blend is not below the lowest of the materials at the same directions: detailFloor().

/// From this weight on a material bounds the blend. The bound of one of a lower weight fades to the weighted sum, so
/// that the blend is continuous where a weight reaches 0.
inline constexpr double fullBoundWeight = 0.02;

/// The fraction of the bound of a material that a weight has, [0, 1].
inline double boundFraction(double weight) { return weight >= fullBoundWeight ? 1 : weight / fullBoundWeight; }

/// The bound of one material on a blend, 1/sr. The smallest over the materials is the lower bound of the blend, which
/// is not below the lowest material. @param value of the material. @param sum the weighted sum of all materials.
inline Rgb detailFloor(const Rgb& value, const Rgb& sum, double weight) {
  const double fraction = boundFraction(weight);
  return fraction == 1 ? value : sum + fraction * (value - sum);
}

/// D(blend) - sum w_i D(c_i), which may be negative. Samples directions as `blend` does. Reciprocal if all are.
/// @param representations D(c_i), one per weight; those of weight 0 are not evaluated.
std::shared_ptr<const Brdf> changeOfSpace(std::shared_ptr<const Brdf> blend,
                                          std::vector<std::shared_ptr<const Brdf>> representations,
                                          std::span<const double> weights);

/// The same where the representations are tables of transformed values: at a node of the grid D is the inverse
/// transform of the weighted sum of the values; in between it is interpolated. Reciprocal if the grid is. About 0.25
/// microseconds per pair for two materials.
std::shared_ptr<const Brdf> changeOfSpace(std::shared_ptr<const TransformedMixture> mixture,
                                          std::span<const double> weights);

/// The blend of materials in their native form. Evaluates each material once and the change once; the change twice, in
/// both orders of the directions, if it is not reciprocal but all materials are: the blend is then reciprocal, too.
/// Directions are sampled by the densities of the materials, half of them by that of the change if it has one.
std::shared_ptr<const Brdf> withMeasuredDetail(std::vector<std::shared_ptr<const Brdf>> materials,
                                               std::span<const double> weights, std::shared_ptr<const Brdf> change);

/// The blend of tables on one grid, cell by cell; a cell is valid if it is valid in all tables of weight > 0. Values
/// beyond the range of float become the largest float. Parallel. @throws Cancelled.
Interpolation::Table withMeasuredDetail(std::span<const Interpolation::Table> tables, std::span<const double> weights,
                                        const Brdf& change, const TaskControl& control = {});

}  // namespace gonio::interpolation
