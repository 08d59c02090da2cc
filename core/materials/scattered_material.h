// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/io/scattered_samples.h"
#include "core/materials/material.h"

namespace gonio::materials {

/// Makes a whole material of a measurement at scattered pairs of directions: ridge regression over the principal
/// components of the bundled materials (acquisition::reconstruct(); Nielsen et al. 2015, "On Optimal, Minimal BRDF
/// Sampling for Reflectance Acquisition"), sampled onto the MERL grid. The material is isotropic and reciprocal,
/// whatever was measured. No value exceeds both the largest measured one and the largest of the bundled materials at
/// its node. Points at one node of bundledBasisGrid are averaged; where more than 8192 nodes remain, some of them are
/// used, evenly. Fills all of a material but its name, path, format and hash; its notes state how many points were used
/// and left out, and the leave-one-out error. Deterministic. About 1 s, and the learning of bundledBasis() once.
/// @throws Error where no point lies where the bundled materials have values; Cancelled.
void setScattered(const io::ScatteredSamples& samples, const TaskControl& control, Material& material);

}  // namespace gonio::materials
