// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "core/acquisition/sample_selection.h"

class QComboBox;
class QFormLayout;

namespace gonio::widgets {
class ForbiddenRegionsEditor;
class NumberField;
class ParameterSlider;
}  // namespace gonio::widgets

namespace gonio::app {

/// Rows of a form: the number of directions, the selection method, and the limits of the rig.
class DirectionRows : public QObject {
  Q_OBJECT

 public:
  explicit DirectionRows(QFormLayout& form);

  int samples() const;
  void setSamples(int samples);
  acquisition::SelectionMethod method() const;
  acquisition::MeasurableDirections measurable() const;
  std::uint64_t seed() const;
  /// @param noisy whether the simulated noise uses the seed, too.
  void setEnabled(bool enabled, bool noisy);
  QComboBox& methodBox() const { return *m_method; }
  widgets::ForbiddenRegionsEditor& forbidden() const { return *m_forbidden; }

 Q_SIGNALS:
  void edited();
  void seedEdited();

 private:
  void buildSamples(QFormLayout& form);
  void buildMethod(QFormLayout& form);
  void buildRig(QFormLayout& form);
  void connectParts();

  widgets::ParameterSlider* m_samplesSlider;
  QComboBox* m_method;
  widgets::NumberField *m_samples, *m_seed, *m_maxAngle, *m_separation;
  widgets::ForbiddenRegionsEditor* m_forbidden;
};

}  // namespace gonio::app
