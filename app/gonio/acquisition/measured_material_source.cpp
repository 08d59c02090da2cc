// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/measured_material_source.h"

namespace gonio::app {

using Choice = MeasuredMaterialRows::Choice;

MeasuredMaterialSource::MeasuredMaterialSource(const Document& document, AcquisitionSession& session,
                                               AcquisitionControls& controls)
    : QObject(&controls), m_document(document), m_session(session), m_controls(controls) {
  connect(&m_document, &Document::materialChanged, this, &MeasuredMaterialSource::takeOpenMaterial);
  connect(&m_controls.measuredMaterial(), &MeasuredMaterialRows::edited, this, &MeasuredMaterialSource::edited);
  connect(&m_session.referenceReader(), &ReferenceReader::changed, this, &MeasuredMaterialSource::showReference);
}

void MeasuredMaterialSource::takeOpenMaterial() {
  if (m_controls.measuredMaterial().choice() != Choice::openMaterial || !m_controls.isVisible()) return;
  const LoadedMaterialPtr material = m_document.material();
  const std::vector<editing::Edit> edits = m_document.edits();
  const auto base = m_document.base();
  if (base == m_taken && edits == m_takenEdits && m_session.referenceReader().name() == m_document.name()) return;
  m_taken = base;
  m_takenEdits = edits;
  if (!material) return m_session.referenceReader().clear();
  m_session.referenceReader().read(
      QString::fromStdString(material->material.source.path.string()), m_document.name(),
      [base, edits](const TaskControl& control) { return editing::bakeEdits(base, edits, control); });
}

void MeasuredMaterialSource::edited() {
  m_taken.reset();
  if (m_controls.measuredMaterial().choice() == Choice::none) m_session.referenceReader().clear();
  if (m_controls.measuredMaterial().choice() == Choice::openMaterial) takeOpenMaterial();
  if (m_controls.measuredMaterial().choice() == Choice::chosen)
    m_session.referenceReader().read(m_controls.measuredMaterial().chosenId());
}

void MeasuredMaterialSource::choose(const QString& id) {
  m_session.referenceReader().read(id);
  m_controls.measuredMaterial().choose(id, m_session.referenceReader().name());
}

void MeasuredMaterialSource::fixOpenMaterial() {
  if (m_controls.measuredMaterial().choice() == Choice::openMaterial && m_session.referenceReader().reference())
    m_controls.measuredMaterial().choose(m_session.referenceReader().id(), m_session.referenceReader().name());
}

void MeasuredMaterialSource::showReference() {
  if (m_controls.measuredMaterial().choice() == Choice::chosen && !m_session.referenceReader().name().isEmpty())
    m_controls.measuredMaterial().choose(m_session.referenceReader().id(), m_session.referenceReader().name());
  m_controls.training().setMeasuredId(m_session.referenceReader().id());
}

}  // namespace gonio::app

#include "moc_measured_material_source.cpp"
