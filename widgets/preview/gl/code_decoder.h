// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <memory>
#include <optional>

#include "widgets/preview/gl/code_texels.h"

namespace gonio::widgets {

class PreviewResources;

/// Decodes sparse codes on the graphics card, in three steps of mode products: coefficients into fibres along phi_d,
/// fibres into slabs over phi_d and theta_d, slabs into the table. Same result as dictionary::decode() on the CPU, up
/// to single-precision rounding. For K coefficients in G groups and A slabs (code_texels.h) on a 90 x 90 x 180 grid
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
  void decode(QOpenGLFunctions_4_1_Core& gl, PreviewResources& resources, const CodeTexels& texels, GLuint& texture);
  void release(QOpenGLFunctions_4_1_Core& gl);

 private:
  void bindWeights(QOpenGLFunctions_4_1_Core& gl, const HalfDifferenceGrid& grid);

  GLuint weights_ = 0;
  std::optional<HalfDifferenceGrid> weightsGrid_;
};

}  // namespace gonio::widgets
