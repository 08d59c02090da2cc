// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Where the controls of an acquisition stand, and what they say.
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>

#include "app/gonio/acquisition/acquisition_controls.h"
#include "widgets/acquisition/forbidden_regions_editor.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"

namespace gonio::app {

namespace {

using acquisition::SelectionMethod;

QLabel* heading(const QString& text) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  label->setContentsMargins(0, 6, 0, 0);
  return label;
}

widgets::NumberField* field(const QString& name, const QString& toolTip, double least, double most, double step,
                            const QString& unit, double factor = 1) {
  auto* number = new widgets::NumberField;
  number->setRange(least, most);
  number->setStep(step);
  number->setUnit(unit, factor);
  number->setAccessibleName(name);
  number->setToolTip(toolTip);
  number->setFixedWidth(6 * number->fontMetrics().height());
  return number;
}

}  // namespace

void AcquisitionControls::buildSubject(QFormLayout& form) {
  m_subject = new QComboBox;
  m_subject->addItems({tr("The open material"), QString(), tr("None: values of a rig"), tr("Choose...")});
  m_subject->setToolTip(
      tr("The material that is measured in simulation, and that the reconstruction is compared with. With values of a "
         "rig there may be none."));
  form.addRow(tr("Meas&ure"), m_subject);
  m_noise = field(tr("Noise"), tr("Standard deviation of a simulated reading, as a share of its value"), 0, 1, 0.01,
                  tr("%"), 100);
  m_floor = field(tr("Noise floor"), tr("Standard deviation of the sensor in the dark, beside its relative noise"), 0,
                  10, 1e-3, tr("1/sr"));
  m_misalignment = field(tr("Misalignment"),
                         tr("Standard deviation of the direction of each arm, along each of two "
                            "axes"),
                         0, radians(10), radians(0.1), QStringLiteral("°"), degrees(1));
  form.addRow(tr("&Noise"), m_noise);
  form.addRow(tr("Noise floor"), m_floor);
  form.addRow(tr("Misali&gnment"), m_misalignment);
}

void AcquisitionControls::buildTraining(QFormLayout& form) {
  form.addRow(heading(tr("Training set")));
  m_training = new QComboBox;
  m_training->addItems({tr("Measured, of the library"), tr("Published fits, of the library"), tr("The whole library"),
                        tr("What the library shows"), QString(), tr("A folder of files...")});
  m_training->setToolTip(
      tr("The materials from which it is learned what materials are like.\n"
         "The whole library tells more than the measured materials alone, and takes about a minute to learn at first.\n"
         "\"What the library shows\": those that its search leaves, also of a folder."));
  form.addRow(tr("&Learn from"), m_training);
  m_leaveOut = new QCheckBox(tr("Leave out the measured material"));
  m_leaveOut->setToolTip(
      tr("Neither the material that is measured nor another file of the same name is learned from: otherwise its "
         "reconstruction looks better than that of a new material."));
  m_leaveOut->setChecked(true);
  form.addRow(m_leaveOut);
  m_trainingFacts = new QLabel;
  m_trainingFacts->setForegroundRole(QPalette::PlaceholderText);
  m_trainingFacts->setWordWrap(true);
  form.addRow(m_trainingFacts);
}

void AcquisitionControls::buildSamples(QFormLayout& form) {
  form.addRow(heading(tr("Directions")));
  const QString toolTip = tr("m: how many pairs of directions are measured, %1 to %2")
                              .arg(AcquisitionSession::fewestSamples)
                              .arg(AcquisitionSession::mostSamples);
  m_samplesSlider = new widgets::ParameterSlider;
  m_samplesSlider->setRange(AcquisitionSession::fewestSamples, AcquisitionSession::mostSamples,
                            models::ParameterScale::linear);
  m_samplesSlider->setReference(PlanSettings().samples);
  m_samplesSlider->setAccessibleName(tr("Samples"));
  m_samplesSlider->setToolTip(toolTip);
  m_samples = field(tr("Samples"), toolTip, AcquisitionSession::fewestSamples, AcquisitionSession::mostSamples, 1, {});
  m_samples->setFixedWidth(3 * fontMetrics().height());
  auto* row = new QHBoxLayout;
  row->addWidget(m_samplesSlider, 1);
  row->addWidget(m_samples);
  auto* label = new QLabel(tr("Sam&ples m"));
  label->setBuddy(m_samples);
  form.addRow(label, row);
  m_method = new QComboBox;
  const std::tuple<SelectionMethod, QString, QString> methods[] = {
      {SelectionMethod::simultaneousPursuit, tr("SOMP, all signals"),
       tr("Simultaneous orthogonal matching pursuit over all training signals (FROST)")},
      {SelectionMethod::simultaneousPursuitFirstColumns, tr("SOMP, as released"),
       tr("The same over the first signals alone, as many as there are samples: what the authors' code does")},
      {SelectionMethod::conditionNumber, tr("Condition number"),
       tr("The search of Nielsen et al. 2015: slower by far, the more so the more samples")},
      {SelectionMethod::random, tr("Random"), tr("Every measurable cell as likely as any other")},
      {SelectionMethod::uniform, tr("Uniform"), tr("Spread evenly over the directions")}};
  for (const auto& [method, name, explanation] : methods) {
    m_method->addItem(name, int(method));
    m_method->setItemData(m_method->count() - 1, explanation, Qt::ToolTipRole);
  }
  m_method->setToolTip(tr("How the directions are chosen"));
  form.addRow(tr("Metho&d"), m_method);
  m_seed = field(tr("Seed"), tr("Another number: other random directions, other noise"), 1, 1e6, 1, {});
  form.addRow(tr("Seed"), m_seed);
  setSamples(PlanSettings().samples);
  m_seed->setValue(1);
}

void AcquisitionControls::buildRig(QFormLayout& form) {
  form.addRow(heading(tr("What the rig can see")));
  const acquisition::MeasurableDirections usual;
  m_largestAngle = field(tr("Largest polar angle"), tr("Neither light nor viewer gets nearer to the horizon"),
                         radians(10), halfPi, radians(1), QStringLiteral("°"), degrees(1));
  m_largestAngle->setValue(usual.largestPolarAngle);
  m_separation = field(tr("Arms apart"),
                       tr("The least angle between light and viewer: nearer, one arm stands before "
                          "the other"),
                       0, halfPi, radians(1), QStringLiteral("°"), degrees(1));
  m_separation->setValue(usual.smallestSeparation);
  form.addRow(tr("Largest θ"), m_largestAngle);
  form.addRow(tr("Arms apart"), m_separation);
  m_forbidden = new widgets::ForbiddenRegionsEditor;
  form.addRow(new QLabel(tr("Out of reach, degrees")));
  form.addRow(m_forbidden);
}

void AcquisitionControls::buildReconstruction(QFormLayout& form) {
  form.addRow(heading(tr("Reconstruction")));
  m_reconstruction = new QComboBox;
  const std::pair<QString, QString> methods[] = {
      {tr("Ridge, chosen η"), tr("Tikhonov regularisation over up to %1 components, with the η that predicts each "
                                 "sample best from all others (leave-one-out)")
                                  .arg(mostComponents)},
      {tr("Ridge, published η = %1").arg(acquisition::publishedRidge),
       tr("With the η of the publications, over as many components. It was found for some 400 training signals; with "
          "fewer it flattens too much.")},
      {tr("Sparse"), tr("Few components, chosen by orthogonal matching pursuit; tells no uncertainty")}};
  for (const auto& [name, explanation] : methods) {
    m_reconstruction->addItem(name);
    m_reconstruction->setItemData(m_reconstruction->count() - 1, explanation, Qt::ToolTipRole);
  }
  m_reconstruction->setToolTip(tr("How the material follows from its values"));
  form.addRow(tr("&By"), m_reconstruction);
}

}  // namespace gonio::app
