// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "app/gonio/acquisition/acquisition_session.h"
#include "app/gonio/acquisition/direction_rows.h"
#include "app/gonio/acquisition/subject_rows.h"
#include "app/gonio/acquisition/training_rows.h"

namespace gonio::app {

/// What an acquisition is set to: the material that is measured, the training set, the number of samples and how they
/// are chosen, the limits of the rig, the noise and the method of reconstruction.
class AcquisitionControls : public QWidget {
  Q_OBJECT

 public:
  explicit AcquisitionControls(QWidget* parent = nullptr);

  SubjectRows& subject() const { return *m_subject; }
  TrainingRows& training() const { return *m_training; }
  DirectionRows& directions() const { return *m_directions; }
  QComboBox& reconstructionBox() const { return *m_reconstruction; }

  PlanSettings planSettings() const;
  acquisition::MeasurementNoise noise() const;
  acquisition::ReconstructionOptions reconstruction() const;
  /// Enables what can be changed now.
  void setBusy(bool busy);

 Q_SIGNALS:
  void planSettingsEdited();
  void noiseEdited();
  void reconstructionEdited();

 private:
  enum ReconstructionItem { chosenRidge, publishedRidge, sparse };
  /// Of a ridge that is chosen: more than samples, since the ridge keeps them in check. The time of the uncertainty
  /// grows with their square.
  static constexpr int maxComponents = 100;

  void buildReconstruction(QFormLayout& form);
  void connectRows();
  void refresh();

  bool m_busy = false;
  SubjectRows* m_subject;
  TrainingRows* m_training;
  DirectionRows* m_directions;
  QComboBox* m_reconstruction;
};

}  // namespace gonio::app
