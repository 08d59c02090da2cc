// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/largest_coefficients.h"
#include "core/dictionary/mode_products.h"

namespace gonio::dictionary {

/// selectLargest() of transposedModeProducts(): the largest coefficients of a signal over a dictionary, without
/// computing those that cannot be among them. No coefficient exceeds the norm of the fibre or slice that it is
/// projected from, so the last and most expensive product is computed for few fibres only.
/// @param signal of `sizes`, the first index fastest. @param matrices one per mode, sizes[mode] rows, columns of norm
/// at most 1. @param selected the result, in no particular order; its memory is reused.
/// Takes half the time of the full projection for materials at 262 coefficients.
template <typename Scalar>
void selectLargestProjections(const Scalar* signal, const Sizes& sizes, const ModeMatrices<Scalar>& matrices,
                              std::size_t count, Workspace<Scalar>& workspace,
                              std::vector<Coefficient<Scalar>>& selected);

/// The same for a signal that is already projected onto the atoms of mode 2. @param projected2 sizes[0] x sizes[1] x
/// matrices[2].cols() numbers, the first index fastest.
template <typename Scalar>
void selectLargestOfSlices(const Scalar* projected2, const Sizes& sizes, const ModeMatrices<Scalar>& matrices,
                           std::size_t count, std::vector<Coefficient<Scalar>>& selected);

extern template void selectLargestProjections(const float*, const Sizes&, const ModeMatrices<float>&, std::size_t,
                                              Workspace<float>&, std::vector<Coefficient<float>>&);
extern template void selectLargestProjections(const double*, const Sizes&, const ModeMatrices<double>&, std::size_t,
                                              Workspace<double>&, std::vector<Coefficient<double>>&);
extern template void selectLargestOfSlices(const float*, const Sizes&, const ModeMatrices<float>&, std::size_t,
                                           std::vector<Coefficient<float>>&);
extern template void selectLargestOfSlices(const double*, const Sizes&, const ModeMatrices<double>&, std::size_t,
                                           std::vector<Coefficient<double>>&);

}  // namespace gonio::dictionary
