// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/dictionary/principal_components.h"

namespace gonio::materials {

/// Every second node of MERL tables in theta_h and theta_d, every fourth in phi_d: reconstructions from single points
/// are no better on a finer grid.
inline constexpr HalfDifferenceGrid bundledBasisGrid{.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 45};

/// Principal components of all bundled materials (bundledLibrary()) over bundledBasisGrid: what is known of materials
/// before one is measured. Learned at the first call of a process (5 s), then shared; 19 MB.
/// @throws Cancelled; the next call then starts again.
std::shared_ptr<const dictionary::PrincipalComponents> bundledBasis(const TaskControl& control = {});

}  // namespace gonio::materials
