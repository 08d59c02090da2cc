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

/// Decodes sparse codes on the graphics card, in three passes of mode products: coefficients into fibres along phi_d,
/// fibres into slabs over phi_d and theta_d, slabs into the table. What dictionary::decode() does on the CPU, up to the
/// rounding of single precision. For K coefficients in G groups and A slabs (code_texels.h) of a 90 x 90 x 180 grid
/// that is 180 K + 16,200 G + 1.5e6 A products a channel; the sum over all coefficients at every node would be 1.5e6 K.
///
/// Every call needs the same context to be current.
class CodeDecoder {
 public:
  /// Whether the card's textures are large enough for a code.
  static bool fits(QOpenGLFunctions_4_1_Core& gl, const CodeTexels& texels);
  /// Whether this context draws on the CPU, where decoding costs more than uploading a decoded table.
  static bool isSoftware(QOpenGLFunctions_4_1_Core& gl);

  /// Fills `texture` as uploadTable() does with the decoded table, and makes it when it is 0. The texture that the
  /// active unit has is then this one; all else that is bound stays, but for the units of the decoder.
  /// @throws Error with the compiler's log, or when the card does not draw into its textures.
  void decode(QOpenGLFunctions_4_1_Core& gl, PreviewResources& resources, const CodeTexels& texels, GLuint& texture);
  void release(QOpenGLFunctions_4_1_Core& gl);

 private:
  void bindWeights(QOpenGLFunctions_4_1_Core& gl, const HalfDifferenceGrid& grid);

  GLuint weights_ = 0;
  std::optional<HalfDifferenceGrid> weightsGrid_;
};

}  // namespace gonio::widgets
