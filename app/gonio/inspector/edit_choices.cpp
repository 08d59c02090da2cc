// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/edit_choices.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QStandardItemModel>

#include "app/gonio/document/edit_steps.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/parameters/formula_text.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

using editing::Composition;

CompositionChoice::CompositionChoice(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_choice(new QComboBox), m_keepsAlbedo(new QCheckBox(tr("Keep albedo"))) {
  for (const editing::CompositionRecord& record : editing::compositionRecords) {
    m_choice->addItem(widgets::toQString(record.name));
    m_choice->setItemData(m_choice->count() - 1,
                          QStringLiteral("<p>%1</p><p>%2</p>")
                              .arg(widgets::toQString(record.description).toHtmlEscaped(),
                                   widgets::formulaHtml(record.formula).replace('\n', QStringLiteral("<br>"))),
                          widgets::richToolTipRole);
  }
  m_choice->setToolTip(
      tr("Method that applies the change of the model to the measurement.\n\"Lobes\" preserves the measured "
         "shape of a highlight as it widens; \"Additive\" is the published method."));
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addRow(tr("Composition"), m_choice);
  m_keepsAlbedo->setToolTip(tr(
      "Keeps the directional albedo of highlights at every angle when their width changes: the material gets neither "
      "darker nor brighter.\nA measured peak that the fit does not explain becomes part of the highlight as it "
      "widens.\nOnly with the composition \"Lobes\"."));
  layout->addRow(QString(), m_keepsAlbedo);
  connect(m_keepsAlbedo, &QCheckBox::clicked, this, [this](bool on) { setKeepsAlbedo(m_document, on); });
  connect(m_choice, &QComboBox::activated, this, [this](int index) { setComposition(m_document, Composition(index)); });
  for (const auto signal :
       {&Document::materialChanged, &Document::editChanged, &Document::stateChanged, &Document::selectionChanged})
    connect(&m_document, signal, this, &CompositionChoice::refresh);
  refresh();
}

void CompositionChoice::refresh() {
  const auto* edit = m_document.active<editing::DifferentialEdit>();
  setVisible(edit);
  if (!edit) return;
  auto* items = qobject_cast<QStandardItemModel*>(m_choice->model());
  items->item(int(Composition::lobes))->setEnabled(edit->model->hasLobes());
  m_choice->setCurrentIndex(int(edit->composition));
  m_keepsAlbedo->setEnabled(edit->composition == Composition::lobes);
  m_keepsAlbedo->setChecked(edit->keepsAlbedo);
}

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

#include "moc_edit_choices.cpp"
