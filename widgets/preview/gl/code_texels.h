// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "core/dictionary/sparse_code.h"

namespace gonio::widgets {

/// A sparse code with the ensemble that it is over: what a graphics card can decode for itself.
struct EnsembleCode {
  std::shared_ptr<const dictionary::Ensemble> ensemble;
  dictionary::SparseCode code;
};

/// What shaders/preview/decode_*.frag read of a code. Its coefficients are sorted: a *slab* is all that share an atom
/// of theta_h, a *group* all that share one of theta_d too. Channels stand one behind the other, each with as many
/// groups and slabs as the one that has most (at least one); those that it lacks are empty.
struct CodeTexels {
  static constexpr int layersAtOnce =
      8;  ///< nodes of theta_h that one pass fills: the draw buffers that all cards have

  HalfDifferenceGrid grid;
  DataTransform transform = DataTransform::logPlus;
  std::array<float, 3> highest{};           ///< bounds of the transformed values
  int groups = 0, slabs = 0;                ///< of a channel
  std::vector<glm::vec2> coefficients;      ///< atom of phi_d, value; at least one
  std::vector<glm::vec4> groupRanges;       ///< atom of theta_d, first coefficient, the one after its last
  std::vector<glm::vec4> slabRanges;        ///< first group of its channel, the one after its last
  std::array<std::vector<float>, 2> atoms;  ///< of phi_d and theta_d, over the importance: an atom's nodes side by side
  /// Of theta_h: `slabs` wide. Two rows are eight nodes: of the channel, then of the block of layersAtOnce nodes.
  std::vector<glm::vec4> thetaHAtoms;

  int blocks() const { return (grid.thetaHCount + layersAtOnce - 1) / layersAtOnce; }
};

/// Some 2 ms for 1,024 coefficients over dictionaries of a MERL grid. From any thread.
/// @throws Error as dictionary::checkCode().
CodeTexels codeTexels(const dictionary::Ensemble& ensemble, const dictionary::SparseCode& code);

}  // namespace gonio::widgets
