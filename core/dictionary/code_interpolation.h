// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <span>

#include "core/dictionary/dictionary.h"

namespace gonio::dictionary {

/// The rotations R_j = U_j^T V_j that convert coefficients over V into coefficients over U (Tongbuasirilai 2023,
/// "Data-Driven Approaches for Sparse Reflectance Modeling and Acquisition", eq. 4.43). Computed as the polar factors
/// of these products, which equal the products for square dictionaries (proposition 4.1).
std::array<Eigen::MatrixXd, 3> rotationsBetween(const Dictionary& u, const Dictionary& v);

/// The weighted sum of codes in the transformed domain (Tongbuasirilai 2023, eq. 4.42-4.44), with at most
/// `coefficients` per channel. Codes over a dictionary other than the first code's are converted by rotationsBetween(),
/// which makes them dense; of the sum the largest coefficients remain. The rotations lose nothing, so this is the
/// linear interpolation of the transformed materials, made sparse again. A code of weight 1 is returned bitwise
/// unchanged. If one of the codes has both orders of the directions, so has the sum. @param weights one per code, each
/// in [0, 1], with sum 1 (within 1e-9). @throws Error for other weights, codes that differ in transform or cell scaling
/// (SparseCode::scaled; encode one of them again), and codes that do not fit the ensemble.
SparseCode interpolateCodes(const Ensemble& ensemble, std::span<const SparseCode> codes,
                            std::span<const double> weights, std::size_t coefficients);

}  // namespace gonio::dictionary
