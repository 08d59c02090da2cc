// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_side.h"

namespace gonio::widgets {

PreviewSide::PreviewSide(QObject* parent) : QObject(parent) {
  connect(&m_estimator, &MaterialEstimator::estimated, this, &PreviewSide::adopt);
  connect(&m_estimator, &MaterialEstimator::failed, this, &PreviewSide::failed);
  connect(&m_tracer, &SceneTracer::failed, this, &PreviewSide::failed);
}

bool PreviewSide::setSubject(const PreviewSubject& subject) {
  if (sameSubject(subject, m_given)) return false;
  // The lobe of the step before serves until the new one is known.
  const bool keepsLobe = !subject.isMeasured() && !m_given.isMeasured();
  const auto lobe = keepsLobe ? m_subject.lobe : subject.lobe;
  m_given = m_subject = subject;
  m_subject.lobe = lobe;
  ++m_number;
  m_tracer.stop();
  if (subject.isEmpty()) m_material.reset();
  m_estimator.request(subject);
  return true;
}

void PreviewSide::adopt(const MaterialEstimate& estimate) {
  m_material = estimate.material;
  if (!m_subject.lobe || !areSimilar(*estimate.lobe, *m_subject.lobe)) {
    m_subject.lobe = estimate.lobe;
    ++m_number;
  }
  Q_EMIT estimated();
}

}  // namespace gonio::widgets

#include "moc_preview_side.cpp"
