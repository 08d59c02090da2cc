// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QOpenGLWidget>
#include <QTimer>
#include <memory>
#include <optional>

#include "widgets/preview/frame_budget.h"
#include "widgets/preview/preview_renderer.h"

namespace gonio::widgets {

/// The preview viewport: a material on a sphere, converging while nothing changes, restarting when something does.
/// Left drag orbits (with a directional light: moves the light), middle or right drag orbits always, wheel zooms,
/// Shift + right drag turns the environment, Ctrl + left (or left alone while picking) picks the angle of the viewer at
/// a point, F frames, R resets the view.
class PreviewWidget : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit PreviewWidget(QWidget* parent = nullptr);
  ~PreviewWidget() override;

  /// A null table shows the empty state with a hint.
  void setMaterial(std::shared_ptr<const TabulatedBrdf> table, const SamplingLobe& lobe);
  /// Live: changes uniforms and the sampling density (about 1 ms), no table is rebuilt.
  void setEdit(std::optional<editing::DifferentialEdit> edit);

  void setScene(const SphereScene& scene);
  const SphereScene& scene() const { return scene_; }
  void setExposure(double stops);
  double exposure() const { return display_.exposure; }
  void setToneMap(ToneMap toneMap);
  ToneMap toneMap() const { return display_.toneMap; }
  void setOverlayVisible(bool visible);
  bool overlayVisible() const { return overlayWanted_; }
  /// While picking, a left click or drag picks as Ctrl + left does.
  void setPicking(bool picking);

  /// The picture as shown, without overlay, at the quality reached so far.
  QImage grabPicture();
  /// The linear radiance of the picture as it has converged so far.
  Image linearPicture();
  bool hasMaterial() const { return table_ != nullptr; }
  /// Whether the picture has all the samples that it will get.
  bool converged() const;

 public Q_SLOTS:
  void frameObject();
  void resetView();

 Q_SIGNALS:
  void sceneChanged(const gonio::SphereScene& scene);
  void frameRendered(double milliseconds, int samplesPerPixel);
  void failed(const QString& message);
  /// The user points at the sphere where the viewer stands at this polar angle (rad, [0, pi/2]).
  void polarAnglePicked(double theta);

 protected:
  void initializeGL() override;
  void paintGL() override;
  void resizeGL(int width, int height) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void applyPending();
  SamplingLobe editedLobe() const;
  void renderFrame();
  void restart();
  void placeOverlay();
  void updateOverlay(double milliseconds);
  void dragLight(const QPointF& position);
  bool pick(const QMouseEvent& event);
  QSize pixelSize() const;
  int wantedSamples() const;
  void fail(const QString& message);

  PreviewRenderer renderer_;
  PreviewRenderer::Display display_;
  FrameBudget budget_;
  std::shared_ptr<const TabulatedBrdf> table_;
  SamplingLobe lobe_;
  std::optional<editing::DifferentialEdit> edit_;
  SphereScene scene_;
  bool tablePending_ = false;
  bool overlayWanted_ = true;
  bool picking_ = false;
  QString failure_;
  QPointF lastPosition_;
  QElapsedTimer sinceChange_;
  QTimer frameTimer_;
  QLabel* overlay_;
  QLabel* hint_;
};

}  // namespace gonio::widgets
