// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QColor>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <map>
#include <memory>
#include <optional>

#include "core/brdf/sampling_lobe.h"
#include "core/brdf/tabulated_brdf.h"
#include "core/editing/differential_edit.h"
#include "core/rendering/sphere_scene.h"
#include "core/rendering/tone_map.h"

namespace gonio::widgets {

/// Draws the sphere with OpenGL 4.1 core into an accumulation buffer: the twin of core/rendering/sphere_renderer.h.
/// Knows no widget: tests drive it with an offscreen surface. Every call needs the same current context as
/// initialize(). The shader of a frame contains only what the scene and the edit call for.
class PreviewRenderer : protected QOpenGLFunctions_4_1_Core {
 public:
  ~PreviewRenderer();

  /// @throws Error when the context has no OpenGL 4.1 core functions.
  void initialize();
  /// Frees everything that belongs to the context.
  void release();

  /// Uploads the table (about 20 ms for 90 x 90 x 180); null: nothing to draw.
  void setTable(std::shared_ptr<const TabulatedBrdf> table, const SamplingLobe& lobe);
  /// Uniforms only. The shader of a model is compiled at its first use.
  void setEdit(std::optional<editing::DifferentialEdit> edit);
  /// Density of the reflected samples under an environment. An edit that sharpens a highlight needs a new one, else the
  /// mirror is dark with sparkles.
  void setLobe(const SamplingLobe& lobe);
  void setScene(const SphereScene& scene);
  /// Size of the accumulated picture in pixels.
  void setSize(const QSize& size);

  bool hasMaterial() const { return tableTexture_ != 0; }
  QSize size() const { return size_; }
  /// Samples a pixel accumulated since the last change.
  int samples() const { return samples_; }
  void restart() { samples_ = 0; }

  /// Adds `count` samples to every pixel and waits for the result, so that its time can be taken.
  /// @throws Error with the compiler's log when a shader does not compile.
  void accumulate(int count);

  struct Display {
    double exposure = 0;
    ToneMap toneMap = ToneMap::filmic;
    QColor backgroundCentre{58, 58, 60}, backgroundEdge{34, 34, 36};
  };
  /// Draws the tone-mapped mean into the framebuffer that is bound, over the given viewport.
  void present(const QSize& viewport, const Display& display);

  /// The mean as linear RGB with coverage in alpha: what renderSphere() returns.
  Image readPicture();

 private:
  QOpenGLShaderProgram& sphereProgram();
  void setCameraUniforms(QOpenGLShaderProgram& program);
  void setEditUniforms(QOpenGLShaderProgram& program);
  void setSampleUniforms(QOpenGLShaderProgram& program, int count);
  void bindTextures(QOpenGLShaderProgram& program);
  void uploadEnvironment();

  bool initialized_ = false;
  GLuint vertexArray_ = 0, tableTexture_ = 0, environmentTexture_ = 0, lightPoolTexture_ = 0,
         lightPoolRadianceTexture_ = 0;
  std::map<QString, std::unique_ptr<QOpenGLShaderProgram>> programs_;
  std::unique_ptr<QOpenGLShaderProgram> displayProgram_;
  std::unique_ptr<QOpenGLFramebufferObject> accumulation_;
  double phiPeriod_ = pi;
  SamplingLobe lobe_;
  std::optional<editing::DifferentialEdit> edit_;
  SphereScene scene_;
  std::shared_ptr<const EnvironmentMap> uploadedEnvironment_;
  QSize size_{1, 1};
  int samples_ = 0;
};

}  // namespace gonio::widgets
