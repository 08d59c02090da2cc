// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/noise_filter.h"

#include <span>

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
      bindTexture(gl, program, firstBlendUnit + 2, "knownFeatures", known->featureTexture());
      program.setUniformValue("knownSamples", known->shown().samples);
    }
    program.setUniformValue("samples", float(picture.samples()));
    program.setUniformValue("hasFewSamples", isFew);
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
  pass({known ? "OUTLIERS" : "VARIANCE"}, targets_[0], prepared_->texture());
  // The longest would reach over too much of a picture at a quarter of the resolution.
  for (const QPoint stride : std::span(strides).first(known ? 3 : 4)) filter({"LEVEL"}, stride);
  if (isFew) filter({"LEVEL"}, lastStride);
  if (known) {
    resize(changed_, known->size());
    pass({"ADD"}, changed_, targets_[0]->texture());
  } else {
    filter({});
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

void KnownPicture::keep(PreviewRenderer& renderer, NoiseFilter* filter) {
  release();
  subject_ = renderer.subject();
  samples_ = renderer.samples();
  picture_ = renderer.takeBuffer();
  if (filter) filtered_ = filter->takeBuffer();
}

void KnownPicture::release() {
  picture_.reset();
  filtered_.reset();
  before_.reset();
  subject_ = {};
}

bool KnownPicture::serves(const PreviewSubject& changed, const QSize& size) const {
  if (!picture_ || picture_->size() != size || subject_.shown.index() != changed.shown.index()) return false;
  if (const auto* edited = std::get_if<EditedMaterial>(&subject_.shown))
    return edited->base == std::get<EditedMaterial>(changed.shown).base;
  if (const auto* alone = std::get_if<StandaloneModel>(&subject_.shown))
    return alone->model == std::get<StandaloneModel>(changed.shown).model;
  if (const auto* blend = std::get_if<PreviewBlend>(&subject_.shown))
    return blend->mixture == std::get<PreviewBlend>(changed.shown).mixture;
  return false;
}

void KnownPicture::drawBefore(PreviewRenderer& renderer, const QSize& size, int samples) {
  const PreviewSubject changed = renderer.subject();
  if (before_ && before_->size() == size && samplesBefore_ == samples && subject_.density == changed.density) return;
  subject_.density = changed.density;
  renderer.setSubject(subject_);
  renderer.setSize(size);
  renderer.accumulate(samples);
  before_ = renderer.takeBuffer();
  samplesBefore_ = samples;
  renderer.setSubject(changed);
}

ShownPicture KnownPicture::shown() const {
  if (filtered_) return {filtered_->texture(), 1};
  return {picture_ ? picture_->texture() : 0, float(samples_)};
}

}  // namespace gonio::widgets
