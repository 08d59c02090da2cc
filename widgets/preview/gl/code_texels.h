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

/// A sparse code with its ensemble of dictionaries, which the graphics card can decode.
struct EnsembleCode {
  std::shared_ptr<const dictionary::Ensemble> ensemble;
  dictionary::SparseCode code;
};

/// A sparse code in the layout of shaders/preview/decode_*.frag. The coefficients are sorted: a *slab* is the set of
/// all that share an atom of theta_h, a *group* the set of all that share an atom of theta_d as well. The channels
/// follow each other, each padded with empty groups and slabs to the largest number of a channel (at least one).
struct CodeTexels {
  static constexpr int layersAtOnce = 8;  ///< nodes of theta_h per pass: the number of draw buffers that every card has

  HalfDifferenceGrid grid;
  DataTransform transform = DataTransform::logPlus;
  std::array<float, 3> highest{};       ///< maximum transformed value per channel
  int groups = 0, slabs = 0;            ///< numbers per channel
  std::vector<glm::vec2> coefficients;  ///< atom of phi_d, value; at least one
  std::vector<glm::vec4> groupRanges;   ///< atom of theta_d, first coefficient, one past the last
  std::vector<glm::vec4> slabRanges;    ///< first group, counted within the channel, and one past the last
  /// Atoms of phi_d and theta_d, without cell scaling (dictionary::unscaledAtoms()); the nodes of an atom are
  /// contiguous.
  std::array<std::vector<float>, 2> atoms;
  /// Atoms of theta_h in rows of `slabs` texels: per channel and block of layersAtOnce nodes two rows, each of four
  /// nodes.
  std::vector<glm::vec4> thetaHAtoms;

  int blocks() const { return (grid.thetaHCount + layersAtOnce - 1) / layersAtOnce; }
};

/// About 2 ms for 1,024 coefficients with dictionaries on a MERL grid. Thread-safe.
/// @throws Error as dictionary::checkCode().
CodeTexels codeTexels(const dictionary::Ensemble& ensemble, const dictionary::SparseCode& code);

}  // namespace gonio::widgets
