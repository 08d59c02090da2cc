// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "app/gonio/acquisition/acquisition_planner.h"
#include "app/gonio/acquisition/acquisition_result.h"
#include "app/gonio/acquisition/reference_reader.h"
#include "app/gonio/document/document.h"

namespace gonio::app {

/// An acquisition without its widgets: chooses directions, simulates or takes measured values, reconstructs the
/// material and measures the error. Each step runs in the background and starts the next one.
class AcquisitionSession : public QObject {
  Q_OBJECT

 public:
  static constexpr int minSamples = 5, maxSamples = 60;
  /// How many points a curve has at most.
  struct CurvePoint {
    int samples;
    AcquisitionError error;
  };
  enum class Step { idle, learning, choosing, reconstructing, measuringCurve };

  /// @param tasks may end before the session, never run on after it.
  explicit AcquisitionSession(BackgroundTasks& tasks, QObject* parent = nullptr);

  /// The material that is measured and compared with.
  ReferenceReader& referenceReader() { return m_referenceReader; }
  const ReferenceReader& referenceReader() const { return m_referenceReader; }

  /// Chooses directions anew, and reports each as it is chosen. With a reference it is measured then.
  /// @param given a plan that was made before, to take instead.
  void plan(const PlanSettings& settings, const std::optional<acquisition::SamplingPlan>& given = {});
  const AcquisitionPlanner& planner() const { return m_planner; }
  /// Stops what is under way. What is there stays.
  void cancel();
  Step step() const { return m_step; }
  bool isBusy() const { return m_step != Step::idle; }
  /// Fraction of the current step, [0, 1].
  double fraction() const;
  /// Whether the reference, or a copy of it, is among the materials that were learned.
  bool isReferenceLearned() const { return m_planner.hasLearned(m_referenceReader.id()); }

  /// From now on the reference is measured with this noise.
  void simulate(const acquisition::MeasurementNoise& noise);
  /// Values of a rig, one per sample. @param name where they are from. @throws Error when there are not as many.
  void setValues(const acquisition::MeasuredValues& values, const QString& name);
  const acquisition::MeasuredValues& values() const { return m_values; }
  bool isSimulated() const { return m_simulated; }
  QString valuesName() const { return m_valuesName; }

  void setReconstruction(const acquisition::ReconstructionOptions& options);
  const acquisition::ReconstructionOptions& reconstructionOptions() const { return m_options; }
  /// Null until it is there.
  const AcquisitionResultPtr& result() const { return m_result; }
  const std::vector<CurvePoint>& curve() const { return m_curve; }

  /// Writes the reconstructed table into a folder, as a MERL file named after it, and makes it the document's material:
  /// one undo step.
  void open(Document& document, const QString& folder);
  bool isOpening() const;
  /// "chrome from 20 samples"
  QString resultName() const;

 Q_SIGNALS:
  /// Another direction is chosen, or all are forgotten.
  void directionsChanged();
  void planChanged();
  void valuesChanged();
  void resultChanged();
  void curveChanged();
  /// Another step, or it went on.
  void progressed();
  void failed(const QString& title, const QString& text);

 private:
  /// One key for all steps: a step takes the place of the one before.
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
  QString m_valuesOf, m_resultOf;  ///< which material was measured
  bool m_simulated = true;
  acquisition::ReconstructionOptions m_options;
  AcquisitionResultPtr m_result;
  std::vector<CurvePoint> m_curve;
  Step m_step = Step::idle;
};

}  // namespace gonio::app
