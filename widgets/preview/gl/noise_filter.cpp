// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/noise_filter.h"

#include <span>

#include "widgets/preview/gl/known_picture.h"

namespace gonio::widgets {

namespace {

// The basis of the lattice of each level: 1, 2.2, 4.1 and 8.1 pixels apart, in different directions, because lattices
// along the rows only would leave a woven pattern around bright pixels.
constexpr QPoint strides[] = {{1, 0}, {2, 1}, {4, -1}, {7, 4}};
constexpr QPoint lastStride{1, 1};  // takes the grain that the others leave of the first samples
constexpr int fewSamples = 8;

void bindTexture(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program, int unit, const char* name,
                 GLuint texture) {
  gl.glActiveTexture(GL_TEXTURE0 + GLenum(unit));
  gl.glBindTexture(GL_TEXTURE_2D, texture);
  program.setUniformValue(name, unit);
}

using Buffer = std::unique_ptr<QOpenGLFramebufferObject>;

void resize(Buffer& buffer, const QSize& size, int textures = 1) {
  if (buffer && buffer->size() == size) return;
  buffer = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::NoAttachment, GL_TEXTURE_2D,
                                                      GL_RGBA32F);
  if (textures == 2) buffer->addColorAttachment(size, GL_RGBA32F);
}

}  // namespace

void NoiseFilter::apply(QOpenGLFunctions_4_1_Core& gl, PreviewResources& resources, const PreviewRenderer& picture,
                        const KnownPicture* known) {
  gl.glDisable(GL_DEPTH_TEST);
  gl.glDisable(GL_BLEND);
  const bool isFew = picture.samples() < fewSamples;
  const auto pass = [&](QStringList definitions, Buffer& target, GLuint filtered, QPoint stride = {}) {
    if (known) definitions << "CHANGE";
    QOpenGLShaderProgram& program = resources.program("preview/noise_filter.frag", definitions);
    program.bind();
    bindTexture(gl, program, accumulationUnit, "accumulation", picture.accumulationTexture());
    bindTexture(gl, program, otherAccumulationUnit, "features", picture.featureTexture());
    bindTexture(gl, program, colourMapUnit, "filtered", filtered);
    bindTexture(gl, program, factorUnit, "guide", prepared_->textures()[1]);
    if (known) {
      bindTexture(gl, program, firstBlendUnit, "before", known->beforeTexture());
      bindTexture(gl, program, firstBlendUnit + 1, "known", known->shown().texture);
      program.setUniformValue("knownSamples", known->shown().samples);
    }
    program.setUniformValue("samples", float(picture.samples()));
    program.setUniformValue("usesNeighbours", known || isFew);
    gl.glUniform2i(program.uniformLocation("stride"), stride.x(), stride.y());
    target->bind();
    constexpr GLenum outputs[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    gl.glDrawBuffers(definitions.contains("PREPARE") ? 2 : 1, outputs);
    gl.glViewport(0, 0, target->width(), target->height());
    resources.drawFullscreen();
    target->release();
    program.release();
  };
  const auto filter = [&](const QStringList& definitions, QPoint stride = {}) {
    pass(definitions, targets_[1], targets_[0]->texture(), stride);
    std::swap(targets_[0], targets_[1]);
  };
  resize(prepared_, picture.size(), 2);
  for (Buffer& target : targets_) resize(target, picture.size());
  pass({"PREPARE"}, prepared_, 0);
  pass({"VARIANCE"}, targets_[0], prepared_->texture());
  // The longest would reach over too much of a picture at a quarter of the resolution.
  for (const QPoint stride : std::span(strides).first(known ? 3 : 4)) filter({"LEVEL"}, stride);
  if (isFew) filter({"LEVEL"}, lastStride);
  filter({});
  if (known) {
    gl.glBindTexture(GL_TEXTURE_2D, targets_[0]->texture());
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    resize(changed_, known->size());
    pass({"ADD"}, changed_, targets_[0]->texture());
  } else {
    changed_.reset();
  }
  gl.glFinish();
}

ShownPicture NoiseFilter::shown() const {
  const Buffer& buffer = changed_ ? changed_ : targets_[0];
  return {buffer ? buffer->texture() : 0, 1};
}

void NoiseFilter::release() {
  for (Buffer* buffer : {&prepared_, &targets_[0], &targets_[1], &changed_}) buffer->reset();
}

}  // namespace gonio::widgets
