// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>

#include "core/math/marginal_warp.h"

namespace gonio::widgets {

/// Textures of one context, which must be current when they are destroyed.
class TextureSet {
 public:
  TextureSet() = default;
  TextureSet(const TextureSet&) = delete;
  TextureSet& operator=(const TextureSet&) = delete;
  ~TextureSet();

  /// Binds texture number `index`, created at first use, to a unit.
  void bind(QOpenGLFunctions_4_1_Core& gl, std::size_t index, GLenum target, int unit);

 private:
  std::vector<GLuint> names_;
};

/// Uploads floats to the bound texture, `channels` per texel (1, 2 or 4), with linear filtering, clamped at the
/// borders.
void uploadFloats(QOpenGLFunctions_4_1_Core& gl, int channels, int width, int height, int depth, const float* texels);
void uploadFloats(QOpenGLFunctions_4_1_Core& gl, int channels, int width, int height, const float* texels);

/// Uploads a warp for shaders/preview/marginal_warp.glsl: textures 0 (3D, the cells) and 1 (2D, the rows) of a set.
void uploadWarp(QOpenGLFunctions_4_1_Core& gl, TextureSet& textures, const MarginalWarp& warp, int cellUnit,
                int rowUnit);

}  // namespace gonio::widgets
