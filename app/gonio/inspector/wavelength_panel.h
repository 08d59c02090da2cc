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

/// Choice between the RGB rendition of a spectral material under D65 and a single wavelength, sampled with the edits in
/// the background; hidden for all other materials. A setting of the view: not undoable, not saved, and reset for each
/// material.
class WavelengthPanel : public QWidget {
  Q_OBJECT

 public:
  WavelengthPanel(Document& document, BackgroundTasks& tasks, QWidget* parent = nullptr);

  /// The subjects shown in place of the material; nullopt: RGB, or not sampled yet.
  const std::optional<WavelengthSubjects>& subjects() const { return m_subjects; }
  /// Whether subjects() belong to the current document and slider position.
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
  bool m_sampling = false, m_again = false;  ///< only one sampling at a time, so that a drag shows intermediate
                                             ///< wavelengths
};

}  // namespace gonio::app
