// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QTimer>

#include "widgets/preview/preview_side.h"

namespace gonio::widgets {

/// A further material of a scene with several materials, in the forms for the shader and the path tracer.
struct SlotMaterial {
  PreviewSubject subject = {};  ///< with its density; empty: none
  std::shared_ptr<const rendering::RenderMaterial> material = nullptr;
};

/// When the path tracer is used.
enum class Tracing {
  never,   ///< the shader renders everything
  atRest,  ///< replaces the shader's picture at rest, because it is more exact or faster
  always,  ///< the shader cannot render the scene
};

/// The content of the preview: one subject, or two in comparison, in one scene. Plans the effects that the scene needs
/// and starts path tracing for scenes that the shader cannot render, or not as well. Independent of OpenGL and the
/// widget.
class PreviewContent : public QObject {
  Q_OBJECT

 public:
  explicit PreviewContent(QObject* parent = nullptr);

  /// Sets the first subject. Its sampling density is estimated in the background. Until then the previous density
  /// is used if neither the previous nor the new subject is a base without edits, else subject.density. An unchanged
  /// subject does not restart the picture.
  void setSubject(const PreviewSubject& subject, const QString& name = {});
  /// Sets the second subject of comparisons. It costs nothing if it is empty or the mode is off.
  void setSecond(const PreviewSubject& subject, const QString& name);
  void setComparison(const PreviewComparison& comparison);
  const PreviewComparison& comparison() const { return m_comparison; }
  /// Whether two subjects are shown.
  bool isComparing() const;
  const PreviewSide& first() const { return m_first; }
  const PreviewSide& second() const { return m_second; }
  bool hasMaterial() const { return !m_first.subject().isEmpty(); }

  /// Shows another scene, to which the view is reset from now on (home()). Environment and background chosen by the
  /// user stay.
  void showScene(const rendering::Scene& scene);
  /// Changes the view or the lighting of the scene.
  void setScene(const rendering::Scene& scene);
  /// Changes the view only: cheaper than setScene(), because in the plan only the area lights visible to the camera
  /// change.
  void setView(const rendering::OrbitCamera& camera, double environmentRotation);
  const rendering::Scene& scene() const { return m_scene; }
  /// The scene to which the view is reset.
  const rendering::Scene& home() const { return m_home; }
  /// Sets the environment of this and all later scenes; null: a distant light instead.
  void setEnvironment(const std::shared_ptr<const rendering::EnvironmentMap>& environment);
  /// Every scene uses its own light again.
  void resetEnvironment();
  /// Whether the scene's light was set by setEnvironment().
  bool isEnvironmentChosen() const { return m_environment.has_value(); }
  /// Sets whether the environment is visible behind the objects, and blurred, in this and all later scenes.
  void setBackground(bool shown, bool blurred);
  /// Sets the materials of the scene's other slots: slot i shows materials[i - 1], or the subject if that is empty or
  /// missing.
  void setOtherSlotMaterials(const std::vector<SlotMaterial>& materials);
  rendering::RenderMaterials otherSlotMaterials() const;
  /// Sets effects that the user forces on or off.
  void setOverrides(const rendering::EffectOverrides& overrides);
  const rendering::EffectOverrides& overrides() const { return m_overrides; }
  /// Sets the number of reflections after which all paths end: the picture of the first path terms. 0: no such limit.
  void setReflectionLimit(int reflections);
  const rendering::EffectThresholds& thresholds() const { return m_thresholds; }
  /// The plan for the first subject, or for a grey surface until its material is known.
  const rendering::EffectPlan& plan() const { return m_first.plan(); }
  /// Replaces it by rendering::checkedPlan() of the same scene, material and overrides, until one of these changes.
  void setCheckedPlan(const rendering::EffectPlan& checked);
  Tracing tracing() const;
  /// Sets whether OpenGL runs on the CPU. If so, meshes are path-traced at rest, which is twice as fast.
  void setSoftware(bool software);

  /// @param pixels size of the whole viewport.
  void setViewport(const QSize& pixels);
  const QSize& viewport() const { return m_viewport; }
  /// Size of one side, in pixels.
  QSize pictureSize() const;
  int wantedSamples() const;
  /// Whether the samples have noise.
  bool isNoisy() const;
  /// Whether an estimate or path tracing is running.
  bool isBusy() const;
  /// The request for rendering.
  PictureRequest request() const;

 Q_SIGNALS:
  /// Changed by the user.
  void changed();
  /// Changed by background work: a better estimate, or more path-traced samples.
  void refined();
  /// The comparison mode or the names changed, but not the pictures.
  void comparisonChanged();
  void sceneChanged(const gonio::rendering::Scene& scene);
  /// The plan of the first subject changed, or its material is now known.
  void planChanged(const gonio::rendering::EffectPlan& plan);
  void failed(const QString& message);

 private:
  void show(PreviewSide& side, const PreviewSubject& subject, const QString& name);
  void connectSide(PreviewSide& side);
  rendering::EffectPlan planOf(const PreviewSide& side) const;
  void setPlans(const rendering::EffectPlan& first, const rendering::EffectPlan& second);
  bool showsOtherSlotMaterials() const;
  void trace(PreviewSide& side);
  void traceBoth();
  void startTracing(PreviewSide& side);
  bool isWorthShowing(const PreviewSide& side) const;
  void notifySceneChange();
  void light(rendering::Scene& scene) const;

  PreviewSide m_first, m_second;
  rendering::EffectThresholds m_thresholds;
  PreviewComparison m_comparison;
  rendering::Scene m_scene, m_home;
  std::optional<std::shared_ptr<const rendering::EnvironmentMap>> m_environment;  ///< set by the user
  struct Background {
    bool shown, blurred;
    void show(rendering::Scene& scene) const;
  };
  std::optional<Background> m_background;  ///< set by the user
  rendering::EffectOverrides m_overrides;
  std::vector<SlotMaterial> m_otherSlotMaterials;  ///< from slot 1 on
  QSize m_viewport{1, 1};
  QTimer m_rest;  ///< starts path tracing once the picture is at rest
  bool m_software = false;
};

}  // namespace gonio::widgets
