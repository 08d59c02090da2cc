// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "core/acquisition/measured_values.h"

class QComboBox;
class QFormLayout;

namespace gonio::widgets {
class NumberField;
}

namespace gonio::app {

/// Rows of a form: the measured material, and the noise of a simulated measurement.
class MeasuredMaterialRows : public QObject {
  Q_OBJECT

 public:
  enum class Choice { openMaterial, chosen, none };

  explicit MeasuredMaterialRows(QFormLayout& form);

  Choice choice() const;
  /// Selects a fixed material, independent of the open one.
  void choose(const QString& id, const QString& name);
  QString chosenId() const;
  acquisition::MeasurementNoise noise(std::uint64_t seed) const;
  bool isNoisy() const;
  QComboBox& box() const { return *m_box; }

 Q_SIGNALS:
  /// The user selected another item.
  void edited();
  /// The user wants to choose another measured material.
  void wanted();
  void noiseEdited();

 private:
  /// Items of the box; the first are those of Choice.
  enum Item { openMaterial, chosenMaterial, noMaterial, chooseMaterial };
  void build(QFormLayout& form);
  void activated(int index);
  void refresh();

  int m_last = 0;
  QComboBox* m_box;
  widgets::NumberField *m_noise, *m_floor, *m_misalignment;
};

}  // namespace gonio::app
