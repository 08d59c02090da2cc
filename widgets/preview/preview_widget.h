// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>
#include <memory>
#include <optional>

#include "widgets/preview/frame_budget.h"
#include "widgets/preview/gl/preview_display.h"
#include "widgets/preview/material_estimator.h"
#include "widgets/preview/scene_tracer.h"

namespace gonio::widgets {

class PreviewOverlay;

/// The preview viewport: a material in a scene, converging while nothing changes, restarting when something does; or
/// two subjects against each other, in one scene. Only the effects that the scene calls for are simulated. Scenes of
/// spheres and rectangles are drawn by the shader, others traced on the CPU.
/// Left drag orbits (with one distant light alone: moves the light), middle or right drag orbits always, wheel zooms,
/// Shift + right drag turns the environment, Ctrl + left (or left alone while picking) picks the angle of the viewer at
/// a point, F frames, R resets the view.
class PreviewWidget : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit PreviewWidget(QWidget* parent = nullptr);
  ~PreviewWidget() override;

  /// The first subject: a table without an edit. A null table shows the empty state with a hint.
  void setMaterial(std::shared_ptr<const TabulatedBrdf> table, const SamplingLobe& lobe);
  /// The first subject. Its lobe is that of the table; what an edit or a model alone needs is estimated in the
  /// background. A subject that is as before does not restart its picture.
  void setSubject(const PreviewSubject& subject, const QString& name = {});
  /// The second subject of comparisons. It costs nothing while it is empty or the mode is off.
  void setOther(const PreviewSubject& subject, const QString& name);
  void setComparison(const PreviewComparison& comparison);
  const PreviewComparison& comparison() const { return comparison_; }
  /// Whether two subjects are shown.
  bool isComparing() const;
  /// The difference that has the last colour now.
  double differenceRange() const { return range_; }

  /// Another scene, whose view resetView() comes back to.
  void showScene(const Scene& scene);
  /// The scene seen or lit otherwise.
  void setScene(const Scene& scene);
  /// The scene from elsewhere: cheaper than setScene(), since the plan stays but for the lamps that the camera sees.
  void setView(const OrbitCamera& camera, double environmentRotation);
  const Scene& scene() const { return scene_; }
  /// Puts an environment into the scene; null: a distant light in its place.
  void setEnvironment(const std::shared_ptr<const EnvironmentMap>& environment);
  /// What the scene's other places show: number i is others[i - 1]; the subject itself where that is null or missing.
  void setOthers(const RenderMaterials& others);
  const RenderMaterials& others() const { return others_; }
  /// Effects that the user forces on or off.
  void setOverrides(const EffectOverrides& overrides);
  const EffectOverrides& overrides() const { return overrides_; }
  /// Of the first subject; for a grey surface until its material is known.
  const EffectPlan& plan() const { return first_.plan; }
  /// Whether the scene is traced on the CPU: the shader knows neither meshes nor several materials.
  bool isTraced() const;
  /// The first subject as rendering takes it; null while it is not known.
  const std::shared_ptr<const RenderMaterial>& material() const { return first_.material; }
  void setExposure(double stops);
  double exposure() const { return settings_.exposure; }
  void setToneMap(ToneMap toneMap);
  ToneMap toneMap() const { return settings_.toneMap; }
  void setOverlayVisible(bool visible);
  bool overlayVisible() const;
  PreviewOverlay* overlay() const { return overlay_; }
  /// While picking, a left click or drag picks as Ctrl + left does.
  void setPicking(bool picking);

  /// The picture as shown, without overlay, at the quality reached so far.
  QImage grabPicture();
  /// The linear radiance of the first subject as it has converged so far.
  Image linearPicture();
  bool hasMaterial() const { return first_.picture.hasMaterial(); }
  /// Whether the picture has all the samples that it will get.
  bool converged() const;

 public Q_SLOTS:
  void frameObject();
  void resetView();
  /// In a comparison: shows the second subject while it is on.
  void setFlickering(bool flickering);

 Q_SIGNALS:
  void sceneChanged(const gonio::Scene& scene);
  /// The plan of the first subject is another, or its material is known now.
  void planChanged(const gonio::EffectPlan& plan);
  void frameRendered(double milliseconds, int samplesPerPixel);
  void failed(const QString& message);
  /// The user points at the sphere where the viewer stands at this polar angle (rad, [0, pi/2]).
  void polarAnglePicked(double theta);
  /// By the user, on the picture.
  void splitMoved(double share);

 protected:
  void initializeGL() override;
  void paintGL() override;
  void resizeGL(int width, int height) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Side {
    explicit Side(const std::shared_ptr<PreviewResources>& resources) : picture(resources) {}
    PreviewRenderer picture;
    PreviewSubject subject;
    QString name;
    MaterialEstimator estimator;
    std::shared_ptr<const RenderMaterial> material;
    EffectPlan plan;
    SceneTracer tracer;
    std::shared_ptr<const Film> shown;  ///< of the tracer, as the picture has it
  };
  struct PicturePosition {
    double x, y, aspect;  ///< x, y in [-1, 1], y up
  };
  void changeSubject(Side& side, const PreviewSubject& subject, const QString& name);
  void adopt(Side& side, const MaterialEstimate& estimate);
  void plan(Side& side);
  void adoptPlan(Side& side, const EffectPlan& plan);
  void trace(Side& side);
  void showSceneChange();
  void showTraced();
  void renderFrame();
  void updateRange();
  void restart();
  void release();
  void changed();
  void showOverlay();
  void updateStatus(double milliseconds);
  void dragLight(const QPointF& position);
  bool pick(const QMouseEvent& event);
  PicturePosition picturePosition(const QPointF& position) const;
  bool needsFrames(const Side& side) const;
  QSize pixelSize() const;
  QSize pictureSize() const;
  int wantedSamples() const;
  void fail(const QString& message);

  std::shared_ptr<PreviewResources> resources_;
  Side first_, second_;
  PreviewDisplay display_;
  DisplaySettings settings_;
  FrameBudget budget_;
  Scene scene_, home_;
  EffectOverrides overrides_;
  RenderMaterials others_;
  PreviewComparison comparison_;
  double range_ = 0;      ///< 0: not found yet
  int rangeSamples_ = 0;  ///< at which the range was found
  bool flickering_ = false;
  bool picking_ = false;
  QString failure_;
  QPointF lastPosition_;
  QElapsedTimer sinceChange_;
  QTimer frameTimer_;
  PreviewOverlay* overlay_;
};

}  // namespace gonio::widgets
