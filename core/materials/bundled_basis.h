// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <vector>

#include "core/dictionary/principal_components.h"

namespace gonio::materials {

/// Every second node of MERL tables in theta_h and theta_d, every fourth in phi_d: reconstructions from single points
/// are no better on a finer grid.
inline constexpr HalfDifferenceGrid bundledBasisGrid{.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 45};

/// What is known of materials before one is measured, over bundledBasisGrid.
struct BundledBasis {
  dictionary::PrincipalComponents components;  ///< of the measured and near-measured bundled materials
  std::vector<float> largest;  ///< of each cell, the largest value of a channel of a bundled material, 1/sr
};

/// Learned at the first call of a process (5 s), then shared; 19 MB. @throws Cancelled; the next call then starts
/// again.
std::shared_ptr<const BundledBasis> bundledBasis(const TaskControl& control = {});

}  // namespace gonio::materials
