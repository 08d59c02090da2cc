// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/brdf/tabulated_brdf.h"
#include "core/dictionary/mode_products.h"
#include "core/dictionary/signals.h"
#include "core/dictionary/sparse_code.h"

namespace gonio::dictionary {

/// What few coefficients compose, but for the last product: the block is slabs * atoms.
template <typename Scalar>
struct ComposedSlabs {
  Matrix<Scalar> slabs;  ///< modes 0 and 1 (rows) of each atom of mode 2 that has a coefficient
  Matrix<Scalar> atoms;  ///< these atoms as rows
};
template <typename Scalar>
ComposedSlabs<Scalar> composeSlabs(const ModeMatrices<Scalar>& matrices, std::vector<Coefficient<Scalar>> coefficients);

/// S x_0 U_0 x_1 U_1 x_2 U_2 of few coefficients, into `block` (count(sizes) numbers): one mode at a time, so that the
/// cost is that of one product with as many columns as there are distinct atoms of mode 2.
template <typename Scalar>
void compose(const ModeMatrices<Scalar>& matrices, std::vector<Coefficient<Scalar>> coefficients, Scalar* block);

/// The atoms divided by the importance of their nodes: what composes transformed values and not scaled signals.
std::array<Eigen::MatrixXd, 3> unscaledAtoms(const Dictionary& dictionary, const GridGeometry& geometry);

/// The transformed values of every cell of a code, in single precision.
std::array<Eigen::ArrayXf, 3> decodeSignals(const Ensemble& ensemble, const SparseCode& code);

/// The table that a code stands for; cells below the horizon are invalid. Negative values become 0. Under 50 ms on two
/// cores for a MERL grid.
/// @throws Error when the code's grid or a dictionary is not of the ensemble.
std::shared_ptr<const TabulatedBrdf> decode(const Ensemble& ensemble, const SparseCode& code);

/// @throws Error when a code cannot be of this ensemble.
void checkCode(const Ensemble& ensemble, const SparseCode& code);

}  // namespace gonio::dictionary
