// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/widgets/shader_pass.h"

namespace gonio::test {

/// The step of the weights of the linear filter of textures, measured: graphics cards round weights to 1/256, software
/// renderers hardly. A context must be current.
inline double filterStep(widgets::PreviewResources& resources) {
  constexpr int count = 4096;
  QOpenGLFunctions_4_1_Core gl;
  gl.initializeOpenGLFunctions();
  GLuint texture = 0;
  const QByteArray fragment =
      "#version 410 core\nuniform sampler2D ends;\nout vec4 value;\nvoid main() {\n"
      "  value = texture(ends, vec2(0.25 + 0.5 * gl_FragCoord.x / " +
      QByteArray::number(count) + ".0, 0.5));\n}\n";
  const auto values = shaderPass(resources, fragment, count, 1, [&](QOpenGLShaderProgram& program) {
    const std::array<float, 2> ends{0, 1};
    gl.glGenTextures(1, &texture);
    gl.glActiveTexture(GL_TEXTURE0);
    gl.glBindTexture(GL_TEXTURE_2D, texture);
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, 2, 1, 0, GL_RED, GL_FLOAT, ends.data());
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    program.setUniformValue("ends", 0);
  });
  gl.glDeleteTextures(1, &texture);

  double error = 0;
  for (int i = 0; i < count; ++i)
    error = std::max(error, std::abs(double(values[std::size_t(i)].r) - (i + 0.5) / count));
  return 2 * error;
}

}  // namespace gonio::test
