// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/dictionary/sparse_code.h"

namespace gonio::dictionary {

/// The rotations R_j = U_j^T V_j that carry coefficients over V into coefficients over U (dissertation eq. 4.43): the
/// polar factors of these products, which are the products themselves for square dictionaries (proposition 4.1).
std::array<Eigen::MatrixXd, 3> rotationsBetween(const Dictionary& u, const Dictionary& v);

/// The code between codes, sum of weight times code in the transformed domain (dissertation eq. 4.42-4.44), with at
/// most `coefficients` per channel: codes over another dictionary than the first one's are carried over by their
/// rotations, which makes them dense, and the largest coefficients are kept. Since the rotations lose nothing, this is
/// the linear interpolation of the transformed materials, re-sparsified. A weight of 1 gives its code back bit for bit.
/// @param weights as many as codes, each in [0, 1], with the sum 1 (to 1e-9).
/// @throws Error for other weights, for codes of different transforms (encode one of them again), and for those that
/// cannot be of the ensemble.
SparseCode interpolateCodes(const Ensemble& ensemble, std::span<const SparseCode> codes,
                            std::span<const double> weights, std::size_t coefficients);

}  // namespace gonio::dictionary
