// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "app/gonio/acquisition/acquisition_planner.h"
#include "app/gonio/acquisition/acquisition_result.h"
#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"

namespace gonio::app {

/// Reads the reference of an acquisition in the background: the measured material, with which the result is compared. A
/// new request replaces the running one.
class ReferenceReader : public QObject {
  Q_OBJECT

 public:
  using TableFactory = std::function<std::shared_ptr<const TabulatedBrdf>(const TaskControl&)>;

  explicit ReferenceReader(BackgroundTasks& tasks, QObject* parent = nullptr);

  /// Sets size and samples of the pictures of later references.
  void setPicture(const rendering::RenderOptions& picture) { m_picture = picture; }
  /// @param id a file or a material of the library
  void read(const QString& id);
  /// @param makeTable called in another thread
  void read(const QString& id, const QString& name, TableFactory makeTable);
  void clear();

  /// Null until it has been read.
  const AcquisitionReferencePtr& reference() const { return m_reference; }
  /// Id of the reference, also while it is being read; empty: none.
  QString id() const { return m_id; }
  QString name() const { return m_name; }
  bool isReading() const;

 Q_SIGNALS:
  /// Id, name or reference changed.
  void changed();
  /// The reference was read, or cleared.
  void finished();
  void failed(const QString& title, const QString& text);

 private:
  void start(std::function<AcquisitionReferencePtr(const TaskControl&)> make);
  void finish(const AcquisitionReferencePtr& reference);

  BackgroundTasks& m_tasks;
  rendering::RenderOptions m_picture = acquisitionPicture();
  QString m_id, m_name;
  AcquisitionReferencePtr m_reference;
};

/// An acquisition without widgets: selects directions, simulates measured values or takes given ones, reconstructs the
/// material and measures the error. Each step runs in the background and starts the next one.
class AcquisitionSession : public QObject {
  Q_OBJECT

 public:
  static constexpr int minSamples = 5, maxSamples = 60;
  /// A point of the error curve.
  struct CurvePoint {
    int samples;
    AcquisitionError error;
  };
  enum class Step { idle, learning, choosing, reconstructing, measuringCurve };

  /// @param tasks may be destroyed before the session; its tasks end with the session.
  explicit AcquisitionSession(BackgroundTasks& tasks, QObject* parent = nullptr);

  /// Reader of the reference: the measured material, with which the result is compared.
  ReferenceReader& referenceReader() { return m_referenceReader; }
  const ReferenceReader& referenceReader() const { return m_referenceReader; }

  /// Starts a new selection of directions and reports each as it is selected. Afterwards the reference is measured, if
  /// there is one.
  /// @param given an existing plan to use instead.
  void plan(const PlanSettings& settings, const std::optional<acquisition::SamplingPlan>& given = {});
  const AcquisitionPlanner& planner() const { return m_planner; }
  /// Stops the current step; existing results stay.
  void cancel();
  Step step() const { return m_step; }
  bool isBusy() const { return m_step != Step::idle; }
  /// Progress of the current step, [0, 1].
  double fraction() const;
  /// Whether the reference, or a copy of it, is among the learned materials.
  bool isReferenceLearned() const { return m_planner.hasLearned(m_referenceReader.id()); }

  /// Simulates measurements of the reference with this noise from now on.
  void simulate(const acquisition::MeasurementNoise& noise);
  /// Sets the values measured by a rig, one per sample. @param name their origin. @throws Error if the number is
  /// different.
  void setValues(const acquisition::MeasuredValues& values, const QString& name);
  const acquisition::MeasuredValues& values() const { return m_values; }
  bool isSimulated() const { return m_simulated; }
  QString valuesName() const { return m_valuesName; }

  void setReconstruction(const acquisition::ReconstructionOptions& options);
  const acquisition::ReconstructionOptions& reconstructionOptions() const { return m_options; }
  /// Null until there is a result.
  const AcquisitionResultPtr& result() const { return m_result; }
  const std::vector<CurvePoint>& curve() const { return m_curve; }

  /// Writes the reconstructed table into a folder, as a MERL file with the name resultName(), and emits materialMade().
  void open(const QString& folder);
  /// The same for any table. @param name of the material.
  void openTable(std::shared_ptr<const TabulatedBrdf> table, const QString& name, const QString& folder);
  bool isOpening() const;
  /// "chrome from 20 samples"
  QString resultName() const;

 Q_SIGNALS:
  /// A further direction was selected, or all were dropped.
  void directionsChanged();
  void planChanged();
  void valuesChanged();
  void resultChanged();
  void curveChanged();
  /// The step or its progress changed.
  void progressed();
  /// A material to open in the document's place, and the name of the undo step.
  void materialMade(const LoadedMaterialPtr& material, const QString& text);
  void failed(const QString& title, const QString& text);

 private:
  /// Task key of all steps: a step replaces the previous one.
  inline static const QString stepKey = QStringLiteral("acquisition");
  void setStep(Step step);
  void forgetPlan();
  void forgetResult();
  void followReference();
  void connectPlanner();
  void measureReference();
  void reconstruct();
  void startCurve(const AcquisitionInput& input);
  std::function<void(const QString&)> failure(const QString& title);
  std::function<void()> stopped();
  AcquisitionInput input() const;

  BackgroundTasks& m_tasks;
  ReferenceReader m_referenceReader;
  AcquisitionPlanner m_planner;
  acquisition::MeasurementNoise m_noise;
  acquisition::MeasuredValues m_values;
  QString m_valuesName;
  QString m_valuesOf, m_resultOf;  ///< names of the measured materials
  bool m_simulated = true;
  acquisition::ReconstructionOptions m_options;
  AcquisitionResultPtr m_result;
  std::vector<CurvePoint> m_curve;
  Step m_step = Step::idle;
};

}  // namespace gonio::app
