// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/photograph/photograph_prior.h"

namespace gonio::study {

/// The class of each training material of a prior for photographs: 0 diffuse, 1 glossy (highlightContrast(), of its
/// table on the grid of the prior). About 0.03 s per material.
std::vector<std::size_t> photographClasses(const photograph::PhotographPrior& prior);

}  // namespace gonio::study
