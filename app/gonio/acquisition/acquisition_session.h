// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "app/gonio/acquisition/acquisition_result.h"
#include "app/gonio/acquisition/acquisition_training.h"
#include "app/gonio/document/background_task.h"
#include "app/gonio/document/document.h"
#include "core/acquisition/sample_selection.h"

namespace gonio::app {

/// From what and how the directions are chosen.
struct PlanSettings {
  TrainingSet training = measuredTraining();
  bool leaveOutReference = true;  ///< the measured material teaches nothing of itself
  acquisition::SelectionMethod method = acquisition::SelectionMethod::simultaneousPursuit;
  int samples = 20;
  acquisition::MeasurableDirections measurable;
  std::uint64_t seed = 1;

  bool operator==(const PlanSettings&) const = default;
};

/// An acquisition without its widgets: chooses directions, simulates or takes measured values, reconstructs the
/// material and measures the error. Each step runs in the background and starts the next one.
class AcquisitionSession : public QObject {
  Q_OBJECT

 public:
  static constexpr int fewestSamples = 5, mostSamples = 60;
  /// How many points a curve has at most.
  struct CurvePoint {
    int samples;
    AcquisitionError error;
  };
  enum class Step { idle, learning, choosing, reconstructing, measuringCurve };

  /// @param tasks may end before the session, never run on after it.
  explicit AcquisitionSession(BackgroundTasks& tasks, QObject* parent = nullptr);

  /// Of the pictures that are rendered from now on.
  void setPicture(const RenderOptions& picture) { m_picture = picture; }
  /// The material that is measured and compared with; read in the background.
  void setReference(const QString& id);
  /// The same of a table that is made in the background.
  using TableMaker = std::function<std::shared_ptr<const TabulatedBrdf>(const TaskControl&)>;
  void setReference(const QString& id, const QString& name, TableMaker makeTable);
  void clearReference();
  const AcquisitionReferencePtr& reference() const { return m_reference; }
  QString referenceId() const { return m_referenceId; }
  QString referenceName() const { return m_referenceName; }
  bool isReadingReference() const;

  /// Chooses directions anew: learns the training set, unless the last plan was of the same one, and tells each
  /// direction as it is chosen. With a reference it is measured then.
  void plan(const PlanSettings& settings);
  /// Takes a plan that was made before instead of choosing one, at the nearest cells of what `settings` learn.
  void plan(const PlanSettings& settings, const acquisition::SamplingPlan& given);
  /// Stops what is under way. What is there stays.
  void cancel();
  Step step() const { return m_step; }
  bool isBusy() const { return m_step != Step::idle; }
  /// Share of the current step, [0, 1].
  double share() const;
  const PlanSettings& settings() const { return m_settings; }
  /// Those chosen so far.
  std::vector<DirectionPair> directions() const;
  bool hasPlan() const { return !m_plan.samples.empty(); }
  const acquisition::SamplingPlan& samplingPlan() const { return m_plan; }
  const acquisition::SampleSelection& selection() const { return m_selection; }
  /// Null until a training set is learned.
  const std::shared_ptr<const dictionary::PrincipalComponents>& basis() const { return m_basis; }
  /// How many materials it was learned from.
  int learnedMaterials() const { return int(m_learned.size()); }
  /// Whether the reference, or a copy of it, is among those that were learned.
  bool isReferenceLearned() const;

  /// From now on the reference is measured with this noise.
  void simulate(const acquisition::MeasurementNoise& noise);
  /// Values of a rig, one a sample. @param name where they are from. @throws Error when there are not as many.
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
  void referenceChanged();
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
  struct Planned {
    acquisition::SampleSelection selection;
    acquisition::SamplingPlan plan;
  };
  /// One key for all steps: a step takes the place of the one before.
  inline static const QString stepKey = QStringLiteral("acquisition");
  void setStep(Step step);
  void forgetPlan();
  void forgetResult();
  void install(const AcquisitionReferencePtr& reference);
  void readReference(std::function<AcquisitionReferencePtr(const TaskControl&)> read);
  void start(const PlanSettings& settings, const std::optional<acquisition::SamplingPlan>& given);
  void learn(const QStringList& ids);
  void choose();
  void takeGiven();
  void installPlan(const Planned& planned);
  void takeChosen(int run, std::uint32_t cell);
  void measureReference();
  void reconstruct();
  void startCurve(const AcquisitionInput& input);
  std::function<void(const QString&)> failure(const QString& title);
  std::function<void()> stopped();
  AcquisitionInput input() const;

  BackgroundTasks& m_tasks;
  RenderOptions m_picture = acquisitionPicture();
  QString m_referenceId, m_referenceName;
  AcquisitionReferencePtr m_reference;
  PlanSettings m_settings;
  std::shared_ptr<const dictionary::PrincipalComponents> m_basis;
  QStringList m_learned;                             ///< that m_basis is of
  std::optional<acquisition::SamplingPlan> m_given;  ///< to be taken as it is
  int m_run = 0;                                     ///< numbers the plans: directions of an earlier one are late
  std::vector<std::uint32_t> m_chosen;
  acquisition::SampleSelection m_selection;
  acquisition::SamplingPlan m_plan;
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
