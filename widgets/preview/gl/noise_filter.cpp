// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/noise_filter.h"

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

}  // namespace

void NoiseFilter::apply(QOpenGLFunctions_4_1_Core& gl, PreviewResources& resources, const PreviewRenderer& picture) {
  for (auto& target : targets_)
    if (!target || target->size() != picture.size())
      target = std::make_unique<QOpenGLFramebufferObject>(picture.size(), QOpenGLFramebufferObject::NoAttachment,
                                                          GL_TEXTURE_2D, GL_RGBA32F);
  gl.glViewport(0, 0, picture.size().width(), picture.size().height());
  gl.glDisable(GL_DEPTH_TEST);
  gl.glDisable(GL_BLEND);
  const auto pass = [&](const QStringList& definitions, QPoint stride) {
    QOpenGLShaderProgram& program = resources.program("preview/noise_filter.frag", definitions);
    program.bind();
    bindTexture(gl, program, accumulationUnit, "accumulation", picture.accumulationTexture());
    bindTexture(gl, program, otherAccumulationUnit, "features", picture.featureTexture());
    bindTexture(gl, program, colourMapUnit, "filtered", targets_[0]->texture());
    program.setUniformValue("samples", float(picture.samples()));
    program.setUniformValue("hasFewSamples", picture.samples() < fewSamples);
    gl.glUniform2i(program.uniformLocation("stride"), stride.x(), stride.y());
    targets_[1]->bind();
    resources.drawFullscreen();
    targets_[1]->release();
    program.release();
    std::swap(targets_[0], targets_[1]);
  };
  pass({"PREPARE"}, {});
  for (const QPoint stride : strides) pass({"LEVEL"}, stride);
  if (picture.samples() < fewSamples) pass({"LEVEL"}, lastStride);
  pass({}, {});
  gl.glFinish();
}

ShownPicture NoiseFilter::shown() const { return {targets_[0] ? targets_[0]->texture() : 0, 1}; }

void NoiseFilter::release() {
  for (auto& target : targets_) target.reset();
}

}  // namespace gonio::widgets
