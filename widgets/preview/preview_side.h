// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "widgets/preview/material_estimator.h"
#include "widgets/preview/picture_request.h"
#include "widgets/preview/scene_tracer.h"

namespace gonio::widgets {

/// One subject of the preview with the results of background work: its sampling density and albedo, the plan of its
/// effects, and its path-traced picture if there is one.
class PreviewSide : public QObject {
  Q_OBJECT

 public:
  explicit PreviewSide(QObject* parent = nullptr);

  /// @return whether the subject changed.
  bool setSubject(const PreviewSubject& subject);
  const PreviewSubject& subject() const { return m_subject; }
  void setName(const QString& name) { m_name = name; }
  const QString& name() const { return m_name; }

  void setPlan(const EffectPlan& plan) { m_plan = plan; }
  const EffectPlan& plan() const { return m_plan; }
  /// The subject in the form for core/rendering; null until it is known.
  const std::shared_ptr<const RenderMaterial>& material() const { return m_material; }
  SceneTracer& tracer() { return m_tracer; }
  const SceneTracer& tracer() const { return m_tracer; }
  bool isEstimating() const { return m_estimator.isBusy(); }

  PictureRequest::Side request() const { return {m_subject, m_number, m_plan, nullptr}; }

 Q_SIGNALS:
  /// The material is known; the sampling density may have changed, too.
  void estimated();
  void failed(const QString& message);

 private:
  void adopt(const MaterialEstimate& estimate);

  PreviewSubject m_subject;  ///< with the lobe (sampling density) that is used for rendering
  PreviewSubject m_given;
  int m_number = 0;  ///< of the subject and its lobe
  QString m_name;
  MaterialEstimator m_estimator;
  std::shared_ptr<const RenderMaterial> m_material;
  EffectPlan m_plan;
  SceneTracer m_tracer;
};

}  // namespace gonio::widgets
