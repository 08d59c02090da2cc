// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/incident_direction_choice.h"

#include <QComboBox>
#include <QFormLayout>

namespace gonio::app {

IncidentDirectionChoice::IncidentDirectionChoice(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_choice(new QComboBox) {
  m_choice->addItem(tr("Viewer, as in Mitsuba and pbrt"));
  m_choice->addItem(tr("Light, as stored in the file"));
  m_choice->addItem(tr("Mean of both (reciprocal)"));
  m_choice->setToolTip(
      tr("Direction that is used as the file's incident direction.\nThe measurement is not reciprocal: it changes when "
         "light and viewer are exchanged."));
  m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addRow(tr("&Incident direction"), m_choice);
  connect(m_choice, &QComboBox::activated, this,
          [this](int index) { m_document.setIncident(IncidentDirection(index)); });
  for (const auto signal : {&Document::materialChanged, &Document::editChanged, &Document::stateChanged})
    connect(&m_document, signal, this, &IncidentDirectionChoice::refresh);
  refresh();
}

void IncidentDirectionChoice::refresh() {
  const auto base = m_document.base();
  setVisible(base && base->incidentDirection());
  m_choice->setCurrentIndex(int(m_document.state().incident));
}

}  // namespace gonio::app

#include "moc_incident_direction_choice.cpp"
