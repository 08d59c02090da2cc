// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/acquisition/acquisition_session.h"
#include "app/gonio/acquisition/direction_rows.h"
#include "app/gonio/acquisition/measured_material_rows.h"
#include "app/gonio/acquisition/training_rows.h"

namespace gonio::app {

/// The settings of an acquisition: the measured material, the training set, the number and selection of samples, the
/// limits of the rig, the noise and the reconstruction method.
class AcquisitionControls : public QWidget {
  Q_OBJECT

 public:
  explicit AcquisitionControls(QWidget* parent = nullptr);

  MeasuredMaterialRows& measuredMaterial() const { return *m_measuredMaterial; }
  TrainingRows& training() const { return *m_training; }
  DirectionRows& directions() const { return *m_directions; }
  QComboBox& reconstructionBox() const { return *m_reconstruction; }

  PlanSettings planSettings() const;
  acquisition::MeasurementNoise noise() const;
  acquisition::ReconstructionOptions reconstruction() const;
  /// Enables the controls that can be changed in this state.
  void setBusy(bool busy);

 Q_SIGNALS:
  void planSettingsEdited();
  void noiseEdited();
  void reconstructionEdited();

 private:
  enum ReconstructionItem { localRidge, chosenRidge, publishedRidge, printedRidge, sparse };

  void buildReconstruction(QFormLayout& form);
  void connectRows();
  void refresh();

  bool m_busy = false;
  MeasuredMaterialRows* m_measuredMaterial;
  TrainingRows* m_training;
  DirectionRows* m_directions;
  QComboBox* m_reconstruction;
};

}  // namespace gonio::app
