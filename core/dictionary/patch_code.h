// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/mode_products.h"
#include "core/math/matching_pursuit.h"
#include "core/support/task_control.h"

/// Sparse codes of patches: a signal is cut into blocks of cells, each of which is a sum of few atoms of one
/// dictionary.
namespace gonio::dictionary {

/// Patches of a signal of `sizes` (phi_d, theta_d, theta_h), one per column; phi_d is fastest within a patch and among
/// patches. @throws Error if the sizes are not multiples of the patch's.
Eigen::MatrixXd patchesOf(const Eigen::ArrayXd& signal, const Sizes& sizes, const Sizes& patch);
/// Inverse of patchesOf().
Eigen::ArrayXd signalOf(const Eigen::MatrixXd& patches, const Sizes& sizes, const Sizes& patch);

/// The code of each patch of a signal.
struct PatchCode {
  std::vector<PursuitResult> patches;

  std::size_t coefficients() const;
};

/// Encodes patches by orthogonal matching pursuit with at most `coefficients` coefficients in total. Each patch gets as
/// many coefficients, at most `maxPerPatch`, as it needs to reach an error that is the same for all patches. The
/// patches are encoded twice: first with `maxPerPatch` coefficients each, to find this error (the prefixes of these
/// codes are the codes for larger errors), then with the error that was found. @throws Error as
/// orthogonalMatchingPursuit(); Cancelled.
PatchCode encodePatches(const AtomSet& atoms, const Eigen::MatrixXd& patches, std::size_t coefficients,
                        int maxPerPatch = 32, const TaskControl& control = {});

}  // namespace gonio::dictionary
