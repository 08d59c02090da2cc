// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <functional>

#include "app/gonio/acquisition/acquisition_session.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace gonio::widgets {
class ForbiddenRegionsEditor;
class NumberField;
class ParameterSlider;
}  // namespace gonio::widgets

namespace gonio::app {

/// What an acquisition is set to: the training set, the material that is measured, the number of samples and how they
/// are chosen, the limits of the rig, the noise and the method of reconstruction.
class AcquisitionControls : public QWidget {
  Q_OBJECT

 public:
  enum class Subject { openMaterial, chosen, none };

  explicit AcquisitionControls(QWidget* parent = nullptr);

  /// What the library shows at this time.
  void setShownIds(std::function<QStringList()> shownIds) { m_shownIds = std::move(shownIds); }
  PlanSettings planSettings() const;
  void setSamples(int samples);
  /// A set of materials to learn from beside those that are offered.
  void setTraining(const TrainingSet& training);
  Subject subject() const;
  /// The material that is measured is this one, whatever is opened.
  void setChosenSubject(const QString& name);
  void setSubject(Subject subject);
  /// Which material is left out of the training set.
  void setMeasuredId(const QString& id);
  acquisition::MeasurementNoise noise() const;
  acquisition::ReconstructionOptions reconstruction() const;
  /// Enables what can be changed now.
  void setBusy(bool busy);

  widgets::NumberField& samplesField() const { return *m_samples; }
  widgets::NumberField& noiseField() const { return *m_noise; }
  QComboBox& trainingBox() const { return *m_training; }
  QComboBox& subjectBox() const { return *m_subject; }
  QComboBox& methodBox() const { return *m_method; }
  QComboBox& reconstructionBox() const { return *m_reconstruction; }
  QCheckBox& leaveOutBox() const { return *m_leaveOut; }
  widgets::ForbiddenRegionsEditor& forbidden() const { return *m_forbidden; }

 Q_SIGNALS:
  void planSettingsEdited();
  /// Another kind of subject was chosen.
  void subjectEdited();
  /// Another material shall be chosen to be measured.
  void subjectWanted();
  void noiseEdited();
  void reconstructionEdited();

 private:
  /// Items of the boxes.
  enum Training { measured, fits, library, shownInLibrary, otherSet, folder };
  enum SubjectItem { openMaterial, chosenMaterial, noMaterial, chooseMaterial };
  enum ReconstructionItem { chosenRidge, publishedRidge, sparse };
  /// Of a ridge that is chosen: more than samples, since the ridge keeps them in check. The time of the uncertainty
  /// grows with their square.
  static constexpr int mostComponents = 100;

  void buildTraining(QFormLayout& form);
  void buildSubject(QFormLayout& form);
  void buildSamples(QFormLayout& form);
  void buildRig(QFormLayout& form);
  void buildReconstruction(QFormLayout& form);
  void connectParts();
  void trainingActivated(int index);
  void askForFolder();
  void refresh();
  TrainingSet training() const;
  bool isNoisy() const;

  std::function<QStringList()> m_shownIds;
  TrainingSet m_otherTraining;  ///< a folder's
  int m_lastTraining = 0, m_lastSubject = 0;
  QString m_measuredId;
  QComboBox *m_training, *m_subject, *m_method, *m_reconstruction;
  QCheckBox* m_leaveOut;
  QLabel* m_trainingFacts;
  widgets::ParameterSlider* m_samplesSlider;
  widgets::NumberField *m_samples, *m_seed, *m_largestAngle, *m_separation, *m_noise, *m_floor, *m_misalignment;
  widgets::ForbiddenRegionsEditor* m_forbidden;
};

}  // namespace gonio::app
