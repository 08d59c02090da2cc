// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/brdf/brdf.h"
#include "core/brdf/tabulated_brdf.h"
#include "core/dictionary/dictionary.h"
#include "core/dictionary/mode_products.h"
#include "core/dictionary/signals.h"

namespace gonio::dictionary {

/// A code as a BRDF that is evaluated without a table: at the eight nodes about a pair, the sum of its coefficients,
/// each times the product of three values of atoms, one per mode. The values at the nodes are transformed back and then
/// interpolated, as TabulatedBrdf does: up to rounding it is the table of decode(). Stores a few kB of atoms; about
/// 0.4 microseconds per pair at 262 coefficients per channel. sample() is cosine-weighted. @throws Error if the code
/// does not fit the ensemble (checkCode()).
std::unique_ptr<const Brdf> makeCodeBrdf(const Ensemble& ensemble, const SparseCode& code);

/// The composition of a few coefficients before the last product: the block is slabs * atoms.
template <typename Scalar>
struct ComposedSlabs {
  Matrix<Scalar> slabs;  ///< one column per atom of mode 2 that has a coefficient; rows: modes 0 and 1
  Matrix<Scalar> atoms;  ///< these atoms as rows
};
template <typename Scalar>
ComposedSlabs<Scalar> composeSlabs(const ModeMatrices<Scalar>& matrices, std::vector<Coefficient<Scalar>> coefficients);

/// Writes S x_0 U_0 x_1 U_1 x_2 U_2 for a few coefficients S to `block` (count(sizes) numbers), one mode after another.
/// The cost is about that of one matrix product with as many columns as there are distinct atoms of mode 2.
template <typename Scalar>
void compose(const ModeMatrices<Scalar>& matrices, std::vector<Coefficient<Scalar>> coefficients, Scalar* block);

/// The atoms without cell scaling: divided by GridGeometry::cellScaling at their nodes if `scaled`. compose() of them
/// gives the transformed values of a code. @param scaled SparseCode::scaled of that code.
std::array<Eigen::MatrixXd, 3> unscaledAtoms(const Dictionary& dictionary, const GridGeometry& geometry,
                                             bool scaled = true);

/// The transformed values of a code in every cell, one array per channel. @throws as checkCode().
std::array<Eigen::ArrayXd, 3> decodeSignals(const Ensemble& ensemble, const SparseCode& code);

/// The table of a code; cells below the horizon are invalid, values below ChannelCode::lowest become equal to it,
/// those above ChannelCode::largestValue too. Under
/// 50 ms on two cores for a MERL grid. @throws as checkCode().
std::shared_ptr<const TabulatedBrdf> decode(const Ensemble& ensemble, const SparseCode& code);

/// @throws Error if a code does not fit the ensemble: another grid, a dictionary or index out of range.
void checkCode(const Ensemble& ensemble, const SparseCode& code);

}  // namespace gonio::dictionary
