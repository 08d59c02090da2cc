// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/wavelength_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <algorithm>

#include "core/math/colour.h"
#include "core/rgl/rgl_edit.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"

namespace gonio::app {

namespace {

const QString samplingKey = QStringLiteral("wavelength");
constexpr int allWavelengths = 0, oneWavelength = 1;
/// Where the eye sees best in daylight.
constexpr double firstWavelength = 555;

const RglSpectra* spectraOf(const LoadedMaterialPtr& material) {
  const RglBrdf* file = material ? formOf<RglBrdf>(*material->base) : nullptr;
  return file ? file->tables()->data.spectra.get() : nullptr;
}

WavelengthSubjects sampled(const LoadedMaterialPtr& material, IncidentDirection incident,
                           const editing::EditList& edits, double nanometres, const TaskControl& control) {
  const auto file = formOf<RglBrdf>(*material->base)->withIncident(incident);
  const auto measured =
      widgets::measuredSubject(rgl::atWavelength(*file, nullptr, nanometres, control), material->density);
  if (editing::isIdentity(edits)) return {material, nanometres, measured, measured};
  const auto edited = editing::applyEdits(file->withIncident(IncidentDirection::viewer), edits);
  const auto shown = rgl::atWavelength(*file, edited.get(), nanometres, control);
  return {material, nanometres, measured,
          widgets::measuredSubject(shown, std::make_shared<const TabulatedDensity>(*shown))};
}

}  // namespace

WavelengthPanel::WavelengthPanel(Document& document, BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_tasks(tasks),
      m_choice(new QComboBox),
      m_row(new QWidget),
      m_slider(new widgets::ParameterSlider),
      m_field(new widgets::NumberField) {
  m_choice->addItems({tr("All (RGB under D65)"), tr("One wavelength")});
  m_choice->setToolTip(
      tr("Wavelengths that the preview shows; a single one is shown in grey.\nFiles, plots and figures always use all "
         "wavelengths."));
  m_slider->setAccessibleName(tr("Wavelength"));
  m_field->setUnit(tr(" nm"));
  m_field->setStep(5);
  auto* row = new QHBoxLayout(m_row);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(m_slider, 1);
  row->addWidget(m_field);
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addRow(tr("&Wavelengths"), m_choice);
  layout->addRow(m_row);
  connect(m_choice, &QComboBox::activated, this, &WavelengthPanel::refresh);
  connect(m_slider, &widgets::ParameterSlider::numberEdited, this, &WavelengthPanel::setWavelength);
  connect(m_slider, &widgets::ParameterSlider::resetRequested, this, [this] { setWavelength(firstWavelength); });
  connect(m_field, &widgets::NumberField::valueEdited, this, &WavelengthPanel::setWavelength);
  connect(&m_document, &Document::materialChanged, this, &WavelengthPanel::adoptMaterial);
  for (const auto signal : {&Document::editChanged, &Document::stateChanged})
    connect(&m_document, signal, this, &WavelengthPanel::sample);
  adoptMaterial();
}

void WavelengthPanel::adoptMaterial() {
  const RglSpectra* spectra = spectraOf(m_document.material());
  m_choice->setCurrentIndex(allWavelengths);
  setVisible(spectra);
  if (spectra) {
    const double from = std::max(minVisibleWavelength, double(spectra->nanometres.front())),
                 to = std::min(maxVisibleWavelength, double(spectra->nanometres.back()));
    m_field->setRange(spectra->nanometres.front(), spectra->nanometres.back());
    m_slider->setRange(std::min(from, to), std::max(from, to), models::ParameterScale::linear);
    m_wavelength = std::clamp(firstWavelength, std::min(from, to), std::max(from, to));
    setWavelength(m_wavelength);
  }
  refresh();
}

void WavelengthPanel::setWavelength(double nanometres) {
  m_wavelength = nanometres;
  m_slider->setNumber(nanometres);
  m_field->setValue(nanometres);
  sample();
}

void WavelengthPanel::refresh() {
  m_row->setVisible(m_choice->currentIndex() == oneWavelength);
  if (m_choice->currentIndex() == oneWavelength) return sample();
  m_tasks.drop(samplingKey);
  m_sampling = m_again = false;
  if (!m_subjects) return;
  m_subjects.reset();
  Q_EMIT subjectsChanged();
}

void WavelengthPanel::sample() {
  const LoadedMaterialPtr material = m_document.material();
  if (m_choice->currentIndex() != oneWavelength || !spectraOf(material)) return;
  m_again = m_sampling;
  if (m_sampling) return;
  m_sampling = true;
  const auto ended = [this] {
    m_sampling = false;
    if (m_again) sample();
  };
  m_tasks.run<WavelengthSubjects>(
      {.title = tr("Sampling %1 nm").arg(m_wavelength, 0, 'f', 0), .key = samplingKey, .live = true},
      [material, incident = m_document.state().incident, edits = m_document.edits(), nanometres = m_wavelength](
          const TaskControl& control) { return sampled(material, incident, edits, nanometres, control); },
      [this, ended](WavelengthSubjects subjects) {
        m_subjects = std::move(subjects);
        Q_EMIT subjectsChanged();
        ended();
      },
      [ended](const QString&) { ended(); }, ended);
}

}  // namespace gonio::app

#include "moc_wavelength_panel.cpp"
