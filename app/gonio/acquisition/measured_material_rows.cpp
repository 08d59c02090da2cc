// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/measured_material_rows.h"

#include <QComboBox>
#include <QFormLayout>

#include "app/gonio/acquisition/control_rows.h"
#include "widgets/inputs/number_field.h"

namespace gonio::app {

MeasuredMaterialRows::MeasuredMaterialRows(QFormLayout& form)
    : QObject(&form),
      m_box(rowBox(tr("Material that is measured in simulation and compared with the reconstruction; choose None for "
                      "values measured with a rig"))) {
  build(form);
  connect(m_box, &QComboBox::activated, this, &MeasuredMaterialRows::activated);
  for (widgets::NumberField* number : {m_noise, m_floor, m_misalignment})
    connect(number, &widgets::NumberField::valueEdited, this, &MeasuredMaterialRows::noiseEdited);
  refresh();
}

void MeasuredMaterialRows::build(QFormLayout& form) {
  m_box->addItems({tr("The open material"), QString(), tr("None (measured values)"), tr("Choose...")});
  hideItem(*m_box, chosenMaterial, true);
  form.addRow(tr("Meas&ure"), m_box);
  m_noise = rowField(tr("Noise"), tr("Standard deviation of a simulated reading, in percent of its value"), 0, 1, 0.01,
                     tr("%"), 100);
  m_floor = rowField(tr("Noise floor"),
                     tr("Standard deviation of a simulated reading in the dark, in addition to the relative noise"), 0,
                     10, 1e-3, tr("1/sr"));
  m_misalignment =
      rowField(tr("Misalignment"),
               tr("Standard deviation of the pointing error of each arm, about each of two axes, in degrees"), 0,
               radians(10), radians(0.1), QStringLiteral("°"), degrees(1));
  form.addRow(tr("&Noise"), m_noise);
  form.addRow(tr("Noise floor"), m_floor);
  form.addRow(tr("Misali&gnment"), m_misalignment);
}

void MeasuredMaterialRows::activated(int index) {
  if (index == chooseMaterial) {
    m_box->setCurrentIndex(m_last);
    return Q_EMIT wanted();
  }
  m_last = index;
  refresh();
  Q_EMIT edited();
}

void MeasuredMaterialRows::refresh() {
  for (widgets::NumberField* number : {m_noise, m_floor, m_misalignment}) number->setEnabled(choice() != Choice::none);
}

MeasuredMaterialRows::Choice MeasuredMaterialRows::choice() const { return Choice(m_box->currentIndex()); }

void MeasuredMaterialRows::choose(const QString& id, const QString& name) {
  m_box->setItemText(chosenMaterial, name);
  m_box->setItemData(chosenMaterial, id);
  hideItem(*m_box, chosenMaterial, false);
  m_last = chosenMaterial;
  m_box->setCurrentIndex(m_last);
  refresh();
}

QString MeasuredMaterialRows::chosenId() const { return m_box->itemData(chosenMaterial).toString(); }

acquisition::MeasurementNoise MeasuredMaterialRows::noise(std::uint64_t seed) const {
  return {.relative = m_noise->value(),
          .absolute = m_floor->value(),
          .misalignment = m_misalignment->value(),
          .seed = seed};
}

bool MeasuredMaterialRows::isNoisy() const {
  return m_noise->value() > 0 || m_floor->value() > 0 || m_misalignment->value() > 0;
}

}  // namespace gonio::app

#include "moc_measured_material_rows.cpp"
