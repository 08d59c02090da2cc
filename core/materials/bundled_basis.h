// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <vector>

#include "core/dictionary/principal_components.h"

namespace gonio::materials {

/// Every second node of MERL tables in theta_h and theta_d, every fourth in phi_d. A finer grid does not improve
/// reconstructions from scattered points.
inline constexpr HalfDifferenceGrid bundledBasisGrid{.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 45};

/// The principal components of the bundled materials and the largest of their values, on bundledBasisGrid; used to
/// reconstruct scattered measurements.
struct BundledBasis {
  dictionary::PrincipalComponents components;  ///< of the measured and near-measured bundled materials
  std::vector<float> largest;                  ///< per cell, the largest channel value of all bundled materials, 1/sr
};

/// Computed at the first call in a process (5 s), then shared; 19 MB. @throws Cancelled; the next call then starts
/// again.
std::shared_ptr<const BundledBasis> bundledBasis(const TaskControl& control = {});

}  // namespace gonio::materials
