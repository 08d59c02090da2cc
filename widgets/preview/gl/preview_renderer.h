// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFramebufferObject>
#include <QSize>
#include <deque>

#include "core/rendering/film.h"
#include "widgets/preview/gl/scene_uniforms.h"
#include "widgets/preview/gl/shown_picture.h"
#include "widgets/preview/gl/subject_textures.h"

namespace gonio::widgets {

/// Draws one subject in a scene with OpenGL 4.1 core into an accumulation buffer: the twin of
/// core/rendering/path_tracer.h. Knows no widget: tests drive it with an offscreen surface. The shader of a frame
/// contains only what the scene and the subject call for. Of several materials in a scene each has a pass of its own,
/// which draws what is seen of it; light that goes from one of them to another is left out. The setters need no
/// context; what reads or draws needs the one of initialize().
class PreviewRenderer : protected QOpenGLFunctions_4_1_Core {
 public:
  /// Draws the lone sphere in a distant light until it gets another scene.
  /// @param resources shared by the pictures of one context.
  explicit PreviewRenderer(std::shared_ptr<PreviewResources> resources = std::make_shared<PreviewResources>());
  ~PreviewRenderer() override;

  /// @throws Error when the context has no OpenGL 4.1 core functions.
  void initialize();
  /// Frees what belongs to the context; the resources too unless another picture shares them.
  void release();

  /// What it costs comes with the frame: the upload of a new table (about 20 ms for 90 x 90 x 180); the shader of kinds
  /// of edits and models that were not drawn before; else uniforms, and the small texture of a factor edit's curves.
  void setSubject(const PreviewSubject& subject);
  const PreviewSubject& subject() const { return subject_; }
  /// Density of the reflected samples under an environment. An edit that sharpens a highlight needs a new one, else the
  /// mirror is dark with sparkles.
  void setLobe(std::shared_ptr<const TabulatedLobe> lobe);
  /// A scene of which SceneUniforms::canDraw() says yes, and the plan of its effects.
  /// @param others what the slots after the first show; the subject where one is empty or missing.
  void setScene(const Scene& scene, const EffectPlan& plan, const std::vector<PreviewSubject>& others = {});
  /// Size of the accumulated picture in pixels.
  void setSize(const QSize& size);

  bool hasMaterial() const { return !subject_.isEmpty(); }
  QSize size() const { return size_; }
  /// Samples per pixel accumulated since the last change.
  int samples() const { return samples_; }
  void restart() { samples_ = 0; }

  /// Adds `count` samples to every pixel and waits for the result, so that its time can be taken. Drawn in bands of
  /// some ms, each waited for: what another context draws meanwhile has to wait for no more than one.
  /// @throws Error with the compiler's log when a shader does not compile.
  void accumulate(int count);
  /// Shows a picture that was traced elsewhere, with its features; its size becomes the picture's.
  void showTraced(const Film& film);

  /// RGBA32F: sum over samples() of linear radiance, with the coverage in alpha. 0 before the first frame.
  GLuint accumulationTexture() const { return samples_ > 0 && accumulation_ ? accumulation_->texture() : 0; }
  /// RGBA32F: Film::features. 0 before the first frame.
  GLuint featureTexture() const { return samples_ > 0 && accumulation_ ? accumulation_->textures()[1] : 0; }
  ShownPicture shown() const { return {accumulationTexture(), float(samples_)}; }
  /// The mean as linear RGB with coverage in alpha: what renderPicture() returns.
  Image readPicture();

 private:
  /// Draws what is seen of one material.
  struct Pass {
    const PreviewSubject& subject;
    SubjectTextures& textures;
    int slots;  ///< bits
  };
  std::vector<Pass> passes();
  void addSamples(const Pass& pass, bool isOnly, int count);
  QOpenGLShaderProgram& sceneProgram(const PreviewSubject& subject, bool isOnly);
  void setCameraUniforms(QOpenGLShaderProgram& program);
  void setSampleUniforms(QOpenGLShaderProgram& program, int first, int count);
  void bindTextures(QOpenGLShaderProgram& program);
  void createTarget();
  void prepareTarget(bool isFirstPass);
  void drawInBands();

  std::shared_ptr<PreviewResources> resources_;
  SubjectTextures textures_;
  std::deque<SubjectTextures> otherTextures_;
  std::unique_ptr<QOpenGLFramebufferObject> accumulation_;
  PreviewSubject subject_;
  std::vector<PreviewSubject> others_;
  Scene scene_;
  SceneUniforms sceneUniforms_;
  QSize size_{1, 1};
  int samples_ = 0;
};

}  // namespace gonio::widgets
