// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/dictionary/largest_coefficients.h"
#include "core/dictionary/mode_products.h"

namespace gonio::dictionary {

/// Adds X_(mode) (S x_p U_p x_q U_q)_(mode)^T of a signal X with coefficients S to `z`, where p and q are the two other
/// modes: the matrix from which orthogonalProcrustes() computes the dictionary's matrix of `mode`. Projects the signal
/// only onto the atoms that have coefficients: for few coefficients much faster than the projection onto all.
/// @param block X of `sizes`, the first index fastest. @param matrices U, one per mode, sizes[mode] rows.
/// @param coefficients their indices are those of a block with as many entries in each mode as the matrix of that mode
/// has columns. @param z sizes[mode] x columns.
void addCorrelation(const double* block, const Sizes& sizes, const ModeMatrices<double>& matrices, int mode,
                    std::span<const Coefficient<double>> coefficients, Workspace<double>& workspace,
                    Eigen::MatrixXd& z);

}  // namespace gonio::dictionary
