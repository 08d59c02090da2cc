// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/brdf/brdf.h"
#include "core/dictionary/sparse_code.h"

namespace gonio::dictionary {

/// A code as a BRDF that is evaluated without a table: the sum of its coefficients, each times the product of three
/// values of atoms, one per mode. Atoms are linear between nodes, so the transformed value is trilinear in (sqrt
/// theta_h, theta_d, phi_d) and equals decode() at the nodes. Stores some kB of atoms; under a microsecond per pair at
/// 262 coefficients per channel. sample() is cosine-weighted. @throws Error if the code does not fit the ensemble
/// (checkCode()).
std::unique_ptr<const Brdf> makeCodeBrdf(const Ensemble& ensemble, const SparseCode& code);

}  // namespace gonio::dictionary
