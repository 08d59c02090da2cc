// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "core/dictionary/dictionary.h"

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
  std::array<float, 3> highest{}, lowest{};  ///< bounds of the transformed values per channel
  std::array<float, 3> largestValue{};       ///< bounds of the absolute BRDF values, 1/sr
  int groups = 0, slabs = 0;                 ///< numbers per channel
  std::vector<glm::vec2> coefficients;       ///< atom of phi_d, value; at least one
  std::vector<glm::vec4> groupRanges;        ///< atom of theta_d, first coefficient, one past the last
  std::vector<glm::vec4> slabRanges;         ///< first group, counted within the channel, and one past the last
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

class ProgramCache;

/// Decodes sparse codes on the graphics card, in three steps of mode products: coefficients into fibres along phi_d,
/// fibres into slabs over phi_d and theta_d, slabs into the table. Same result as dictionary::decode() on the CPU, up
/// to single-precision rounding. For K coefficients in G groups and A slabs on a 90 x 90 x 180 grid
/// this takes 180 K + 16,200 G + 1.5e6 A products per channel; the direct sum over all coefficients at every node would
/// take 1.5e6 K.
///
/// All calls need the same current context.
class CodeDecoder {
 public:
  /// Whether a code fits the maximum texture size of the card.
  static bool fits(QOpenGLFunctions_4_1_Core& gl, const CodeTexels& texels);
  /// Whether this context renders on the CPU, where decoding costs more than uploading a decoded table.
  static bool isSoftware(QOpenGLFunctions_4_1_Core& gl);

  /// Fills `texture` as uploadTable() does with the decoded table; creates it if it is 0. Afterwards the texture is
  /// bound to the active unit; other bindings stay, except the units of the decoder.
  /// @throws Error with the compiler's log, or if the card cannot render to the textures.
  void decode(QOpenGLFunctions_4_1_Core& gl, ProgramCache& programs, const CodeTexels& texels, GLuint& texture);
  void release(QOpenGLFunctions_4_1_Core& gl);

 private:
  void bindWeights(QOpenGLFunctions_4_1_Core& gl, const HalfDifferenceGrid& grid);

  GLuint weights_ = 0;
  std::optional<HalfDifferenceGrid> weightsGrid_;
};

}  // namespace gonio::widgets
