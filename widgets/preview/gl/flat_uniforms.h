// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QByteArray>

namespace gonio::widgets {

/// The shader sources of a fullscreen pass.
struct PassShaders {
  QByteArray vertex, fragment;
};

/// Moves uniforms from the fragment shader to the vertex shader, which passes them on as flat inputs. This is faster in
/// software OpenGL: llvmpipe (Mesa 22.3) reads each component of a uniform with a gather over the pixels that it shades
/// together (about 25 instructions), but a flat input with one instruction.
///
/// Scalars, vectors, matrices and short arrays of constant length are moved, in the order of their declarations. A
/// declaration must be on a line of its own or in a #define that contains only declarations. The names of uniforms
/// for glUniform do not change. Long arrays with a length that depends on the scene stay uniforms, because loops index
/// them.
/// @param vectors maximum number of inputs (GL_MAX_VARYING_VECTORS without those of the pass itself); uniforms that do
/// not fit are not moved.
PassShaders withFlatUniforms(const PassShaders& shaders, int vectors);

}  // namespace gonio::widgets
