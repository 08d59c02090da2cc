// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/dictionary/mode_products.h"
#include "core/dictionary/training_materials.h"
#include "core/math/matching_pursuit.h"
#include "tests/studies/research/dictionary/k_svd.h"

/// The classical way of sparse coding, for comparison: signals are cut into patches, each a sum of few atoms of one
/// overcomplete dictionary that K-SVD learned.
/// Signals are transformed and scaled by GridGeometry::importance like the ensemble's (signals.h): what decodePatches()
/// and signalOf() give is divided by it before the inverse transform.
namespace gonio::dictionary {

/// The patches of a signal of `sizes` (phi_d, theta_d, theta_h), one a column, each with phi_d fastest.
/// @throws Error when the sizes are no multiples of the patch's.
Eigen::MatrixXd patchesOf(const Eigen::ArrayXf& signal, const Sizes& sizes, const Sizes& patch);
/// Their inverse.
Eigen::ArrayXf signalOf(const Eigen::MatrixXd& patches, const Sizes& sizes, const Sizes& patch);

struct PatchTrainingOptions {
  Sizes patch{12, 9, 9};
  std::size_t samples = 20000;  ///< patches that are learned from, drawn evenly from all signals
  SignalOptions signals{.transforms = {DataTransform::logPlus}};
  KSvdOptions kSvd;
};

/// Learns atoms from materials, one pass over them. @throws Error as learnKSvd() and patchesOf(); Cancelled.
KSvdResult learnPatchAtoms(const TrainingMaterials& materials, const PatchTrainingOptions& options,
                           const TaskControl& control = {});

/// A code of each patch of a signal.
struct PatchCode {
  std::vector<PursuitResult> patches;

  std::size_t coefficients() const;
};

/// Codes over the atoms with at most so many coefficients in all: patches get as many as bring them below one common
/// error, by orthogonal matching pursuit, at most `mostOfAPatch`. Two pursuits of all patches: one to the end, in which
/// those to any error are the beginnings, and one to the error that was found.
/// @throws Error as orthogonalMatchingPursuit(); Cancelled.
PatchCode encodePatches(const AtomSet& atoms, const Eigen::MatrixXd& patches, std::size_t coefficients,
                        int mostOfAPatch = 32, const TaskControl& control = {});
Eigen::MatrixXd decodePatches(const AtomSet& atoms, const PatchCode& code);

}  // namespace gonio::dictionary
