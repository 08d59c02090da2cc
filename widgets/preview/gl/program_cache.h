// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QByteArray>
#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>

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

/// The linked programs of the fullscreen passes of one OpenGL context. Each combination of scene, base and edits has
/// its own, so that only those that were used last are kept. The context must be current in all calls.
///
/// With the environment variable GONIO_SHADER_OUTPUT=FOLDER, each fragment shader is written to that folder when it is
/// compiled, complete and before withFlatUniforms(): NAME-1.frag, NAME-2.frag, ... The comment `// FILE` precedes the
/// text of each file.
class ProgramCache {
 public:
  /// More than a single picture needs, and more than the combinations that a user is likely to switch between. A
  /// program of a scene takes about 2 MB with software OpenGL.
  static constexpr std::size_t maxPrograms = 32;

  /// The program with the given fragment shader, assembled and linked unless it is kept. The reference is valid until
  /// maxPrograms other programs were used. @throws Error with the compiler's log.
  QOpenGLShaderProgram& program(const QString& fragment, const QStringList& definitions = {},
                                const QStringList& preamble = {});
  /// Draws the whole viewport with the bound program.
  void drawFullscreen(QOpenGLFunctions_4_1_Core& gl);
  void release(QOpenGLFunctions_4_1_Core& gl);

  /// The listener is called before a program is compiled, which can take a second.
  void setCompileListener(std::function<void()> listener) { compileListener_ = std::move(listener); }
  /// Transforms programs with withFlatUniforms(), given this number of vectors; nullopt: no transformation. Frees all
  /// programs.
  void setFlatVectors(std::optional<int> vectors);

 private:
  struct LinkedProgram {
    std::unique_ptr<QOpenGLShaderProgram> program;
    std::uint64_t lastUse = 0;
  };

  void makeRoom();
  std::unique_ptr<QOpenGLShaderProgram> compiled(const QString& fragment, const QStringList& definitions,
                                                 const QStringList& preamble) const;

  std::function<void()> compileListener_;
  std::optional<int> flatVectors_;
  std::map<QString, LinkedProgram> programs_;
  std::uint64_t uses_ = 0;
  GLuint vertexArray_ = 0;
};

}  // namespace gonio::widgets
