// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>

#include "app/gonio/acquisition/acquisition_training.h"
#include "app/gonio/document/background_task.h"
#include "core/acquisition/sample_selection.h"
#include "core/acquisition/sampling_plan.h"

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

/// Chooses the directions of an acquisition in the background: learns the training set, unless the last plan was of the
/// same one, then chooses one direction after the other, or takes those of a plan that was made before.
class AcquisitionPlanner : public QObject {
  Q_OBJECT

 public:
  AcquisitionPlanner(BackgroundTasks& tasks, QString taskKey, QObject* parent);

  /// @param measuredId the material that the settings may leave out of the training set; empty: none.
  /// @param given directions to take at the nearest cells instead of choosing them.
  void plan(const PlanSettings& settings, const QString& measuredId,
            const std::optional<acquisition::SamplingPlan>& given = {});
  /// The plan and its directions, not what was learned.
  void forget();

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
  /// Whether a material, or a copy of it, is among them.
  bool hasLearned(const QString& id) const;

 Q_SIGNALS:
  void learning();
  void choosing();
  /// Another direction is chosen.
  void directionChosen();
  void planned();
  void stopped();
  void failed(const QString& title, const QString& text);

 private:
  void learn(const QStringList& ids);
  void choose();
  void takeGiven();
  void install(const acquisition::SampleSelection& selection, const acquisition::SamplingPlan& plan);
  void takeChosen(int run, std::uint32_t cell);
  std::function<void(const QString&)> failure(const QString& title);

  BackgroundTasks& m_tasks;
  QString m_taskKey;
  PlanSettings m_settings;
  std::shared_ptr<const dictionary::PrincipalComponents> m_basis;
  QStringList m_learned;                             ///< that m_basis is of
  std::optional<acquisition::SamplingPlan> m_given;  ///< to be taken as it is
  int m_run = 0;                                     ///< numbers the plans: directions of an earlier one are late
  std::vector<std::uint32_t> m_chosen;
  acquisition::SampleSelection m_selection;
  acquisition::SamplingPlan m_plan;
};

}  // namespace gonio::app
