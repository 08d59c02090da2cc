// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/dictionary/alternatives/k_svd.h"
#include "core/dictionary/dictionary.h"
#include "core/dictionary/mode_products.h"
#include "core/dictionary/training_materials.h"
#include "core/math/matching_pursuit.h"
#include "core/support/task_control.h"

/// Sparse codes of patches: a signal is cut into blocks of cells, each of which is a sum of few atoms of one
/// unstructured dictionary, which K-SVD learned (Aharon, Elad and Bruckstein 2006); the classical alternative to the
/// ensemble of orthonormal dictionaries.
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

/// Atoms for patches of signals (patch_code.h). The signals are the log-plus signals of an ensemble, with cell scaling.
struct PatchDictionary {
  HalfDifferenceGrid grid;
  Sizes patch;    ///< cells per mode: phi_d, theta_d, theta_h
  AtomSet atoms;  ///< of unit length; at most as many as a patch has cells
  std::vector<std::string> learnedFrom;

  /// Size of the atoms in single precision.
  std::size_t bytes() const { return std::size_t(atoms.length() * atoms.count()) * sizeof(float); }
  /// The largest number of coefficients per channel of a code.
  std::size_t maxCoefficients() const;
};

struct PatchTrainingOptions {
  Sizes patch{12, 9, 9};
  std::size_t samples = 8000;  ///< number of training patches, the same number from each signal, at random positions
  KSvdOptions kSvd{.iterations = 15};
};

/// Learns the atoms in one pass over the materials. With the default options half a minute for 137 MERL tables.
/// @throws Error for more atoms than a patch has cells, and as learnKSvd() and patchesOf(); Cancelled if stopped in the
/// first iteration.
PatchDictionary learnPatchDictionary(const TrainingMaterials& materials, const PatchTrainingOptions& options = {},
                                     const TaskControl& control = {});

/// Encodes a table, quantised. The index of a coefficient is atom + atoms * patch. @param coefficients maximum number
/// per channel; encodePatches() distributes them among the patches of a channel. @throws Error if the table has another
/// grid than the dictionary; Cancelled.
SparseCode encode(const PatchDictionary& dictionary, const TabulatedBrdf& table, std::size_t coefficients,
                  const TaskControl& control = {});

/// The table of a code. Cells below the horizon are invalid. @throws Error if the code has another grid, or an index
/// without an atom.
std::shared_ptr<const TabulatedBrdf> decode(const PatchDictionary& dictionary, const SparseCode& code);

}  // namespace gonio::dictionary
