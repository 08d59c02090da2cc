// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/largest_coefficients.h"
#include "core/dictionary/mode_products.h"

namespace gonio::dictionary {

/// keepLargest() of transposedModeProducts(): the largest coefficients of a signal over a dictionary, without computing
/// those that cannot be among them. No coefficient exceeds the norm of the fibre or slice that it is projected from, so
/// the last and most expensive product is computed for few fibres only.
/// @param signal of `sizes`, the first index fastest. @param matrices one per mode, sizes[mode] rows, columns of norm
/// at most 1. @param kept the result, in no particular order; its memory is reused.
/// Takes half the time of the full projection for materials at 262 coefficients.
void keepLargestProjections(const float* signal, const Sizes& sizes, const ModeMatrices<float>& matrices,
                            std::size_t count, Workspace<float>& workspace, std::vector<Coefficient<float>>& kept);

/// The same for a signal that is already projected onto the atoms of mode 2. @param projected2 sizes[0] x sizes[1] x
/// matrices[2].cols() numbers, the first index fastest.
void keepLargestOfSlices(const float* projected2, const Sizes& sizes, const ModeMatrices<float>& matrices,
                         std::size_t count, std::vector<Coefficient<float>>& kept);

}  // namespace gonio::dictionary
