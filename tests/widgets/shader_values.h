// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <stdexcept>
#include <vector>

#include "tests/support/rounded.h"
#include "widgets/preview/gl/edit_chain.h"
#include "widgets/preview/gl/preview_resources.h"
#include "widgets/preview/gl/shader_base.h"
#include "widgets/preview/gl/shader_library.h"

namespace gonio::test {

/// Values of evaluateBrdf() of shaders/preview/material.glsl at pairs of directions, one per pixel, in the
/// context that is current.
class ShaderValues : protected QOpenGLFunctions_4_1_Core {
 public:
  static constexpr int side = 64, count = side * side;

  /// @param pairs `count` of them, rounded() to float.
  explicit ShaderValues(std::vector<DirectionPair> pairs) : pairs_(std::move(pairs)) {
    initializeOpenGLFunctions();
    target_ = std::make_unique<QOpenGLFramebufferObject>(side, side, QOpenGLFramebufferObject::NoAttachment,
                                                         GL_TEXTURE_2D, GL_RGBA32F);
    glGenVertexArrays(1, &vertexArray_);
    textures_ = std::make_unique<widgets::TextureSet>();
    upload(0, widgets::environmentUnit, &DirectionPair::wi);
    upload(1, widgets::lightPoolUnit, &DirectionPair::wo);
  }
  ~ShaderValues() { glDeleteVertexArrays(1, &vertexArray_); }
  const std::vector<DirectionPair>& pairs() const { return pairs_; }

  /// The values for a base that is not a table. @throws std::runtime_error with the compiler's log.
  std::vector<Rgb> evaluate(const widgets::EditedMaterial& material) {
    const auto program = link(material);
    const auto base = widgets::uploadShaderBase(*this, *material.base);
    widgets::EditChain chain;
    target_->bind();
    program->bind();
    base->bind(*this, *program);
    chain.bind(*this, *program, material.edits, widgets::factorUnit, material.base);
    program->setUniformValue("wiTexture", widgets::environmentUnit);
    program->setUniformValue("woTexture", widgets::lightPoolUnit);
    glViewport(0, 0, side, side);
    glBindVertexArray(vertexArray_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<glm::vec4> values(count);
    glReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, values.data());
    chain.release(*this);
    return {values.begin(), values.end()};
  }

 private:
  void upload(std::size_t index, int unit, Direction DirectionPair::*which) {
    std::vector<glm::vec4> texels;
    for (const DirectionPair& pair : pairs_) texels.emplace_back(glm::vec3(pair.*which), 0);
    textures_->bind(*this, index, GL_TEXTURE_2D, unit);
    widgets::uploadFloats(*this, 4, side, side, &texels.front().x);
  }

  static std::unique_ptr<QOpenGLShaderProgram> link(const widgets::EditedMaterial& material) {
    QStringList definitions, preamble{"math.glsl"};
    widgets::addShaderBase(*material.base, definitions, preamble);
    widgets::EditChain::addVariant(material.edits, definitions, preamble);
    auto program = std::make_unique<QOpenGLShaderProgram>();
    program->addShaderFromSourceCode(QOpenGLShader::Vertex, widgets::assembleShader("preview/fullscreen.vert"));
    program->addShaderFromSourceCode(QOpenGLShader::Fragment,
                                     widgets::assembleShader("preview/material.glsl", definitions, preamble) + R"(
uniform sampler2D wiTexture, woTexture;
out vec4 value;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  value = vec4(evaluateBrdf(texelFetch(wiTexture, at, 0).xyz, texelFetch(woTexture, at, 0).xyz), 1.0);
}
)");
    if (!program->link()) throw std::runtime_error(program->log().toStdString());
    return program;
  }

  std::vector<DirectionPair> pairs_;
  std::unique_ptr<QOpenGLFramebufferObject> target_;
  std::unique_ptr<widgets::TextureSet> textures_;
  GLuint vertexArray_ = 0;
};

}  // namespace gonio::test
