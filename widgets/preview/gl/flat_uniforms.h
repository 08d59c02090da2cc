// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QByteArray>

namespace gonio::widgets {

/// The two texts of a fullscreen pass.
struct PassShaders {
  QByteArray vertex, fragment;
};

/// The same pass with uniforms moved from the fragment shader to the vertex shader, which passes them on as flat
/// inputs. For software OpenGL: llvmpipe (Mesa 22.3) reads each component of a uniform by a gather over the pixels that
/// it shades together, about 25 instructions, but a flat input by one.
///
/// Moves scalars, vectors and matrices, and arrays whose length is a number, in the order of their declarations, each
/// of which stands on a line of its own or in a #define of nothing else; all keep their names for glUniform. Arrays
/// that a scene sizes stay, since they are indexed by variables.
/// @param vectors that inputs may take (GL_MAX_VARYING_VECTORS, less those of the pass itself): what does not fit
/// stays a uniform.
PassShaders withFlatUniforms(const PassShaders& shaders, int vectors);

}  // namespace gonio::widgets
