// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <glm/vec4.hpp>
#include <vector>

#include "widgets/preview/gl/preview_resources.h"
#include "widgets/preview/gl/shader_library.h"

namespace gonio::test {

/// What a fragment shader with one output writes in single precision, pixel by pixel from the lower left, in the
/// current context. @param bind is called with the program, in use, to set its uniforms and bind textures.
template <typename Bind>
std::vector<glm::vec4> shaderPass(widgets::PreviewResources& resources, const QByteArray& fragment, int width,
                                  int height, const Bind& bind) {
  QOpenGLFunctions_4_1_Core gl;
  gl.initializeOpenGLFunctions();
  QOpenGLShaderProgram program;
  if (!program.addShaderFromSourceCode(QOpenGLShader::Vertex, widgets::assembleShader("preview/fullscreen.vert")) ||
      !program.addShaderFromSourceCode(QOpenGLShader::Fragment, fragment) || !program.link())
    qFatal("%s", qPrintable(program.log()));
  // Before the textures: its constructor unbinds that of the active unit.
  QOpenGLFramebufferObject target(width, height, QOpenGLFramebufferObject::NoAttachment, GL_TEXTURE_2D, GL_RGBA32F);
  target.bind();
  gl.glViewport(0, 0, width, height);
  gl.glDisable(GL_BLEND);
  program.bind();
  bind(program);
  resources.drawFullscreen();
  std::vector<glm::vec4> values(std::size_t(width) * std::size_t(height));
  gl.glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, values.data());
  target.release();
  return values;
}

}  // namespace gonio::test
