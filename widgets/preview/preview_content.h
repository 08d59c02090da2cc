// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QTimer>

#include "widgets/preview/preview_side.h"

namespace gonio::widgets {

/// A material beside the subject in scenes of several: as the shader and as the path tracer take it.
struct SceneMaterial {
  PreviewSubject subject = {};  ///< with its lobe; empty: none
  std::shared_ptr<const RenderMaterial> material = nullptr;
};

/// What the path tracer is for.
enum class Tracing {
  never,   ///< the shader draws it all
  atRest,  ///< to take the place of what the shader draws: it is more exact, or faster
  always,  ///< the shader cannot draw the scene
};

/// What the preview shows: a subject, or two against each other, in one scene. Plans the effects that the scene calls
/// for, and has traced what the shader does not draw, or not as well. Knows neither OpenGL nor the widget.
class PreviewContent : public QObject {
  Q_OBJECT

 public:
  explicit PreviewContent(QObject* parent = nullptr);

  /// The first subject. Its lobe is that of the table; what an edit or a model alone needs is estimated in the
  /// background. A subject that is as before does not restart its picture.
  void setSubject(const PreviewSubject& subject, const QString& name = {});
  /// The second subject of comparisons. It costs nothing while it is empty or the mode is off.
  void setOther(const PreviewSubject& subject, const QString& name);
  void setComparison(const PreviewComparison& comparison);
  const PreviewComparison& comparison() const { return m_comparison; }
  /// Whether two subjects are shown.
  bool isComparing() const;
  const PreviewSide& first() const { return m_first; }
  const PreviewSide& second() const { return m_second; }
  bool hasMaterial() const { return !m_first.subject().isEmpty(); }

  /// Another scene, which becomes the home(). The environment and the background that the user chose stay.
  void showScene(const Scene& scene);
  /// The scene seen or lit otherwise.
  void setScene(const Scene& scene);
  /// The scene from elsewhere: cheaper than setScene(), since the plan stays but for the lamps that the camera sees.
  void setView(const OrbitCamera& camera, double environmentRotation);
  const Scene& scene() const { return m_scene; }
  /// What the view is reset to.
  const Scene& home() const { return m_home; }
  /// Puts an environment into this scene and all that follow; null: a distant light in its place.
  void setEnvironment(const std::shared_ptr<const EnvironmentMap>& environment);
  /// Every scene has its own light again.
  void resetEnvironment();
  /// Whether the scene's light is one that was put there by setEnvironment().
  bool isEnvironmentChosen() const { return m_environment.has_value(); }
  /// Whether the environment is seen behind the objects, and out of focus, in this scene and all that follow.
  void setBackground(bool shown, bool blurred);
  /// What the scene's other places show: number i is others[i - 1]; the subject itself where that is empty or missing.
  void setOthers(const std::vector<SceneMaterial>& others);
  RenderMaterials others() const;
  /// Effects that the user forces on or off.
  void setOverrides(const EffectOverrides& overrides);
  const EffectOverrides& overrides() const { return m_overrides; }
  /// Of the first subject; for a grey surface until its material is known.
  const EffectPlan& plan() const { return m_first.plan(); }
  Tracing tracing() const;
  /// Whether OpenGL runs on the CPU: meshes are traced at rest then, which is twice as fast.
  void setSoftware(bool software);

  /// Of the whole viewport, in pixels.
  void setViewport(const QSize& pixels);
  const QSize& viewport() const { return m_viewport; }
  /// Of one side.
  QSize pictureSize() const;
  int wantedSamples() const;
  /// Whether samples differ.
  bool isNoisy() const;
  /// Whether something about it is still being found out, or traced.
  bool isBusy() const;
  /// All of it, as the drawing takes it.
  PictureRequest request() const;

 Q_SIGNALS:
  /// By the user's hand.
  void changed();
  /// From the background: a subject is known better, or traced further.
  void refined();
  /// The pictures are compared otherwise, or have other names; they themselves are as before.
  void comparisonChanged();
  void sceneChanged(const gonio::Scene& scene);
  /// The plan of the first subject is another, or its material is known now.
  void planChanged(const gonio::EffectPlan& plan);
  void failed(const QString& message);

 private:
  void show(PreviewSide& side, const PreviewSubject& subject, const QString& name);
  void connectSide(PreviewSide& side);
  void plan(PreviewSide& side);
  void adoptPlan(PreviewSide& side, const EffectPlan& plan);
  bool showsOthers() const;
  void trace(PreviewSide& side);
  void traceBoth();
  void startTracing(PreviewSide& side);
  bool isWorthShowing(const PreviewSide& side) const;
  void tellSceneChange();
  void light(Scene& scene) const;

  PreviewSide m_first, m_second;
  PreviewComparison m_comparison;
  Scene m_scene, m_home;
  std::optional<std::shared_ptr<const EnvironmentMap>> m_environment;  ///< by the user
  struct Background {
    bool shown, blurred;
    void show(Scene& scene) const;
  };
  std::optional<Background> m_background;  ///< likewise
  EffectOverrides m_overrides;
  std::vector<SceneMaterial> m_others;
  QSize m_viewport{1, 1};
  QTimer m_rest;  ///< runs out when the hand has rested: what is traced at rest begins
  bool m_software = false;
};

}  // namespace gonio::widgets
