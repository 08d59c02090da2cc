// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/comparison/comparison_controller.h"

class QComboBox;

namespace gonio::widgets {
class NumberField;
class ParameterSlider;
}  // namespace gonio::widgets

namespace gonio::app {

/// Chooses whether a spectral material is shown in RGB under D65 or at one wavelength, which it samples with the edits
/// in the background; hidden for all other materials. A way of looking: no undo step, not saved, and another material
/// starts with all wavelengths.
class WavelengthPanel : public QWidget {
  Q_OBJECT

 public:
  WavelengthPanel(Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);

  /// What is shown in place of the material; nothing: all wavelengths, or not sampled yet.
  const std::optional<WavelengthSubjects>& subjects() const { return m_subjects; }
  /// Whether subjects() follow the document and the slider.
  bool isSettled() const { return !m_sampling; }
  QComboBox& choice() { return *m_choice; }
  widgets::ParameterSlider& slider() { return *m_slider; }

 Q_SIGNALS:
  void subjectsChanged();

 private:
  void adoptMaterial();
  void setWavelength(double nanometres);
  void refresh();
  void sample();

  Document& m_document;
  BackgroundTasks& m_tasks;
  QComboBox* m_choice;
  QWidget* m_row;
  widgets::ParameterSlider* m_slider;
  widgets::NumberField* m_field;
  double m_wavelength = 0;  ///< nm
  std::optional<WavelengthSubjects> m_subjects;
  bool m_sampling = false, m_again = false;  ///< one sampling at a time: a drag shows what it passes
};

}  // namespace gonio::app
