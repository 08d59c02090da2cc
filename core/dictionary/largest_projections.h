// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/largest_coefficients.h"
#include "core/dictionary/mode_products.h"

namespace gonio::dictionary {

/// keepLargest() of transposedModeProducts(): the largest coefficients of a signal over a dictionary, without the
/// coefficients that cannot be among them. No coefficient is larger than the norm of the fibre or the slice that it
/// is projected from, so the last and dearest product is taken for few of the fibres.
/// @param signal of `sizes`, the first index fastest. @param matrices one per mode, sizes[mode] rows, columns of
/// norm 1 at most. @param kept the result, in no order; its memory is used again.
/// Half the time of the whole projection for materials at 262 coefficients.
void keepLargestProjections(const float* signal, const Sizes& sizes, const ModeMatrices<float>& matrices,
                            std::size_t count, Workspace<float>& workspace, std::vector<Coefficient<float>>& kept);

/// The same of a signal that is projected onto the atoms of mode 2 already. @param projected2 sizes[0] x sizes[1] x
/// matrices[2].cols() numbers, the first index fastest.
void keepLargestOfSlices(const float* projected2, const Sizes& sizes, const ModeMatrices<float>& matrices,
                         std::size_t count, std::vector<Coefficient<float>>& kept);

}  // namespace gonio::dictionary
