// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/brdf/brdf.h"
#include "core/dictionary/sparse_code.h"

namespace gonio::dictionary {

/// A code as a BRDF that is evaluated without a table: at the eight nodes about a pair, the sum of its coefficients,
/// each times the product of three values of atoms, one per mode. The values at the nodes are transformed back and then
/// interpolated, as TabulatedBrdf does: up to rounding it is the table of decode(). Stores a few kB of atoms; about
/// 0.4 microseconds per pair at 262 coefficients per channel. sample() is cosine-weighted. @throws Error if the code
/// does not fit the ensemble (checkCode()).
std::unique_ptr<const Brdf> makeCodeBrdf(const Ensemble& ensemble, const SparseCode& code);

}  // namespace gonio::dictionary
