// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFramebufferObject>
#include <QSize>
#include <deque>
#include <functional>

#include "core/rendering/film.h"
#include "widgets/preview/gl/preview_display.h"
#include "widgets/preview/gl/scene_uniforms.h"
#include "widgets/preview/gl/subject_textures.h"

namespace gonio::widgets {

/// Renders one subject in a scene with OpenGL 4.1 core to an accumulation buffer: the counterpart of
/// core/rendering/path_tracer.h. It needs no widget, so tests use an offscreen surface. The shader of a frame contains
/// only what the scene and the subject need. If a scene has several materials, each has a separate pass that draws its
/// visible parts; interreflection between them is neglected. The setters need no context; functions that read or draw
/// need the context of initialize().
class PreviewRenderer : protected QOpenGLFunctions_4_1_Core {
 public:
  /// The initial scene is a sphere in a distant light.
  /// @param resources shared by all pictures of one context.
  explicit PreviewRenderer(std::shared_ptr<PreviewResources> resources = std::make_shared<PreviewResources>());
  ~PreviewRenderer() override;

  /// @throws Error if the context has no OpenGL 4.1 core functions.
  void initialize();
  /// Frees the OpenGL objects, including the resources unless another picture shares them.
  void release();

  /// The cost is paid in the next frame: the upload of a new table (about 20 ms for 90 x 90 x 180) and the compilation
  /// of a shader if the kinds of edits and models are new; otherwise only uniforms and the small texture of a factor
  /// edit's curves.
  void setSubject(const PreviewSubject& subject);
  const PreviewSubject& subject() const { return subject_; }
  /// Sets a scene for which SceneUniforms::canDraw() is true, and the plan of its effects.
  /// @param otherSlotSubjects subjects of the slots after the first; empty or missing ones show the first subject.
  /// @returns whether anything but the subject has changed.
  bool setScene(const rendering::Scene& scene, const rendering::EffectPlan& plan,
                const std::vector<PreviewSubject>& otherSlotSubjects = {});
  /// Size of the accumulated picture in pixels.
  void setSize(const QSize& size);

  bool hasMaterial() const { return !subject_.isEmpty(); }
  QSize size() const { return size_; }
  /// Samples per pixel accumulated since the last change.
  int samples() const { return samples_; }
  void restart() { samples_ = 0; }

  /// Adds `count` samples to every pixel and waits for the result, so that the time can be measured. Draws bands of a
  /// few ms and waits for each, so that other contexts wait for at most one band.
  /// @param isObsolete asked after each band of a scene with one material: if true, the samples that not all bands have
  /// are taken back.
  /// @returns whether all were added.
  /// @throws Error with the compiler's log if a shader does not compile.
  bool accumulate(int count, const std::function<bool()>& isObsolete = {});
  /// Replaces the picture, and its size, by a path-traced one with its features.
  void showTraced(const rendering::Film& film);

  /// RGBA32F: sum of samples() samples of linear radiance, with the coverage in alpha. 0 before the first frame.
  GLuint accumulationTexture() const { return samples_ > 0 && accumulation_ ? accumulation_->texture() : 0; }
  /// RGBA32F: Film::features. 0 before the first frame.
  GLuint featureTexture() const { return samples_ > 0 && accumulation_ ? accumulation_->textures()[1] : 0; }
  ShownPicture shown() const { return {accumulationTexture(), float(samples_)}; }
  /// Gives the buffer of both textures away, and restarts.
  std::unique_ptr<QOpenGLFramebufferObject> takeBuffer();
  /// The mean as linear RGB with coverage in alpha, like the result of renderPicture().
  Image readPicture();

 private:
  /// Draws the visible parts of one material.
  struct Pass {
    const PreviewSubject& subject;
    SubjectTextures& textures;
    int slots;  ///< bit mask
  };
  std::vector<Pass> passes();
  bool addSamples(const Pass& pass, bool isOnly, int count, const std::function<bool()>& isObsolete);
  QOpenGLShaderProgram& sceneProgram(const PreviewSubject& subject, bool isOnly);
  void setCameraUniforms(QOpenGLShaderProgram& program);
  void setSampleUniforms(QOpenGLShaderProgram& program, int first, int count);
  void bindTextures(QOpenGLShaderProgram& program);
  void createTarget();
  void prepareTarget(bool isFirstPass);
  int drawInBands(int samples, const std::function<bool()>& isObsolete);
  void takeBack(QOpenGLShaderProgram& program, int rows, int samples);

  std::shared_ptr<PreviewResources> resources_;
  SubjectTextures textures_;
  std::deque<SubjectTextures> otherTextures_;
  std::unique_ptr<QOpenGLFramebufferObject> accumulation_;
  PreviewSubject subject_;
  std::vector<PreviewSubject> otherSlotSubjects_;
  rendering::Scene scene_;
  SceneUniforms sceneUniforms_;
  QSize size_{1, 1};
  int samples_ = 0;
  double rowMs_ = 0;  ///< of a row and sample in the last pass at this size; 0: not known yet
};

}  // namespace gonio::widgets
