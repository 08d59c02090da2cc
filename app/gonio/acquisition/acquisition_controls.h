// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QString>
#include <QWidget>
#include <functional>

#include "app/gonio/acquisition/acquisition_planner.h"
#include "app/gonio/acquisition/acquisition_session.h"
#include "core/acquisition/measured_values.h"
#include "core/acquisition/sample_selection.h"

class QComboBox;
class QLabel;
class QFormLayout;
class QCheckBox;
namespace gonio::widgets {
class NumberField;
}
namespace gonio::widgets {
class ForbiddenRegionsEditor;
class NumberField;
class ParameterSlider;
}  // namespace gonio::widgets

namespace gonio::app {

// Widgets for the rows of the Acquisition panel's form.

QLabel* rowHeading(const QString& text);

/// A field that shows internal values multiplied by `factor`. Range and step are in internal units.
widgets::NumberField* rowField(const QString& name, const QString& toolTip, double minimum, double maximum, double step,
                               const QString& unit, double factor = 1);

/// A combo box for the narrow column, which truncates long names.
QComboBox* rowBox(const QString& toolTip);
/// Hides an item that cannot be selected yet.
void hideItem(QComboBox& box, int item, bool hidden);

/// Rows of a form: the number of directions, the selection method, and the limits of the rig.
class DirectionRows : public QObject {
  Q_OBJECT

 public:
  explicit DirectionRows(QFormLayout& form);

  int samples() const;
  void setSamples(int samples);
  acquisition::SelectionMethod method() const;
  bool isOverAtoms() const;
  acquisition::MeasurableDirections measurable() const;
  std::uint64_t seed() const;
  /// @param noisy whether the simulated noise uses the seed, too.
  void setEnabled(bool enabled, bool noisy);
  QComboBox& methodBox() const { return *m_method; }
  QComboBox& signalsBox() const { return *m_signals; }
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
  QComboBox *m_method, *m_signals;
  widgets::NumberField *m_samples, *m_seed, *m_maxAngle, *m_separation;
  widgets::ForbiddenRegionsEditor* m_forbidden;
};

/// Rows of a form: the training set, and whether the measured material is left out of it.
class TrainingRows : public QObject {
  Q_OBJECT

 public:
  explicit TrainingRows(QFormLayout& form);

  /// Sets the function that returns the ids currently shown in the library.
  void setShownIds(std::function<QStringList()> shownIds) { m_shownIds = std::move(shownIds); }
  TrainingSet training() const;
  study::MaterialClass materialClass() const;
  /// Selects a training set that is not among the offered ones.
  void setTraining(const TrainingSet& training);
  bool leavesMeasuredOut() const;
  /// Sets the material to exclude.
  void setMeasuredId(const QString& id);
  void setEnabled(bool enabled);
  void refresh();
  QComboBox& box() const { return *m_box; }

 Q_SIGNALS:
  void edited();

 private:
  /// Items of the box.
  enum Item { measured, nearMeasured, fits, library, shownInLibrary, otherSet, folder };
  void build(QFormLayout& form);
  void activated(int index);
  void askForFolder();

  std::function<QStringList()> m_shownIds;
  TrainingSet m_otherSet;  ///< training set of a folder
  int m_last = 0;
  QString m_measuredId;
  QComboBox *m_box, *m_class;
  QCheckBox* m_leaveOut;
  QLabel* m_facts;
};

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

/// The settings of an acquisition: the measured material, the training set, the number and selection of samples, the
/// limits of the rig, the noise and the reconstruction method.
class AcquisitionControls : public QWidget {
  Q_OBJECT

 public:
  explicit AcquisitionControls(QWidget* parent = nullptr);

  MeasuredMaterialRows& measuredMaterial() const { return *m_measuredMaterial; }
  TrainingRows& training() const { return *m_training; }
  DirectionRows& directions() const { return *m_directions; }

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
  enum ReconstructionItem { localRidge, chosenRidge, publishedRidge, printedRidge, sparse, basisPursuit };

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
