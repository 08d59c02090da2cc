// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/io/scattered_samples.h"
#include "core/materials/material.h"

namespace gonio::materials {

/// Reconstructs a whole material from a measurement at scattered pairs of directions: ridge regression over the
/// principal components of the bundled materials (acquisition::reconstruct(); Nielsen et al. 2015, "On Optimal, Minimal
/// BRDF Sampling for Reflectance Acquisition"), sampled on the MERL grid. The material is always isotropic and
/// reciprocal. Each value is limited to the maximum of the bundled materials at its node, or to the maximum of all
/// measured values if that is larger. Points at the same node of bundledBasisGrid are averaged; if more than 8192 nodes
/// remain, an evenly spaced subset is used. Sets all members of the material except name, path, format and hash; its
/// notes state the numbers of used and ignored points and the leave-one-out error. Deterministic. About 1 s, plus
/// bundledBasis() at the first call. @throws Error if no point lies where the bundled materials have values; Cancelled.
void setScattered(const io::ScatteredSamples& samples, const TaskControl& control, Material& material);

}  // namespace gonio::materials
