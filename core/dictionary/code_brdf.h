// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/brdf/brdf.h"
#include "core/dictionary/sparse_code.h"

namespace gonio::dictionary {

/// A code as a BRDF that is evaluated without a table: the sum over its coefficients of the products of three entries
/// of atoms. Between nodes the atoms are interpolated linearly, so the transformed value is trilinear in (sqrt theta_h,
/// theta_d, phi_d); at the nodes it is what decode() gives. Some KB of atoms that the code uses, under a microsecond
/// for a pair at 262 coefficients per channel. Sampled by the cosine.
/// @throws Error when the code cannot be of the ensemble.
std::unique_ptr<const Brdf> makeCodeBrdf(const Ensemble& ensemble, const SparseCode& code);

}  // namespace gonio::dictionary
