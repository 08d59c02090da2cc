// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>

#include "app/gonio/document/background_task.h"
#include "core/acquisition/sample_selection.h"
#include "core/acquisition/sampling_plan.h"
#include "core/dictionary/principal_components.h"
#include "core/study/training_files.h"

namespace gonio::app {

/// The materials from which an acquisition learns its principal components.
struct TrainingSet {
  QString name;     ///< name in the interface, e.g. "measured materials of the library"
  QStringList ids;  ///< as materials::readMaterial() takes them

  bool operator==(const TrainingSet&) const = default;
};

/// The default training set: the measured materials of the bundled library, and near-measured copies of materials that
/// are not among them (materials::libraryTrainingPaths()).
TrainingSet libraryTraining();
/// The measured materials of the bundled library.
TrainingSet measuredTraining();
/// The near-measured copies of MERL materials in the bundled library.
TrainingSet nearMeasuredTraining();
/// The published fits in the bundled library.
TrainingSet fittedTraining();
/// The files of measured materials (MaterialFormat::isMeasurement) in a folder, not in its subfolders; no ids if there
/// are none.
TrainingSet folderTraining(const QString& folder);

/// Name of a material independent of its file, in lower case: "cc_iris_purple_gem" for "library:rgl/cc_iris_purple_gem"
/// and for "cc_iris_purple_gem_rgb.bsdf".
QString baseName(const QString& id);
/// The ids without this material and copies of it, which have the same baseName().
QStringList without(const QStringList& ids, const QString& id);

/// study::learnedBasis() of library materials and files of a class. @throws Error also if there are fewer than two
/// materials.
std::shared_ptr<const dictionary::PrincipalComponents> learnLibraryComponents(
    const QStringList& ids, int components, study::MaterialClass materialClass = study::MaterialClass::all,
    const TaskControl& control = {});

/// Settings for the selection of directions.
struct PlanSettings {
  TrainingSet training = libraryTraining();
  study::MaterialClass materialClass = study::MaterialClass::all;  ///< the part of the training set that is used
  bool leaveOutReference = true;  ///< excludes the measured material from the training set
  acquisition::SelectionMethod method = acquisition::SelectionMethod::automatic;
  /// Selects over the atoms of the bundled dictionaries (acquisition::atomComponents()) instead of the principal
  /// components, which still reconstruct the material.
  bool overAtoms = false;
  int samples = 20;
  acquisition::MeasurableDirections measurable;
  std::uint64_t seed = 1;

  bool operator==(const PlanSettings&) const = default;
};

/// Selects the directions of an acquisition in the background: learns the training set, unless it is that of the last
/// plan, then selects one direction after the other or takes those of an existing plan.
class AcquisitionPlanner : public QObject {
  Q_OBJECT

 public:
  AcquisitionPlanner(BackgroundTasks& tasks, QString taskKey, QObject* parent);

  /// @param measuredId the material that the settings may leave out of the training set; empty: none.
  /// @param given existing directions, moved to the nearest cells, to use instead of a selection.
  void plan(const PlanSettings& settings, const QString& measuredId,
            const std::optional<acquisition::SamplingPlan>& given = {});
  /// Forgets the plan and its directions, but not the learned basis.
  void forget();

  const PlanSettings& settings() const { return m_settings; }
  /// The directions selected so far.
  std::vector<DirectionPair> directions() const;
  bool hasPlan() const { return !m_plan.samples.empty(); }
  const acquisition::SamplingPlan& samplingPlan() const { return m_plan; }
  const acquisition::SampleSelection& selection() const { return m_selection; }
  /// The principal components; null until a training set is learned.
  const std::shared_ptr<const dictionary::PrincipalComponents>& basis() const { return m_basis; }
  /// basis(), if it was learned from these materials; otherwise null.
  std::shared_ptr<const dictionary::PrincipalComponents> learned(const QStringList& ids,
                                                                 study::MaterialClass materialClass) const;
  /// Number of materials from which basis() was learned.
  int learnedMaterials() const { return m_basis ? int(m_basis->svd.v.rows() / 3) : 0; }
  /// Whether a material, or a copy of it, is among the learned materials.
  bool hasLearned(const QString& id) const;

 Q_SIGNALS:
  void learning();
  void choosing();
  /// A further direction was selected.
  void directionChosen();
  void planned();
  void stopped();
  void failed(const QString& title, const QString& text);

 private:
  void learn(const QStringList& ids, int components);
  void learnAtoms();
  void choose();
  void takeGiven();
  void install(const acquisition::SampleSelection& selection, const acquisition::SamplingPlan& plan);
  void takeChosen(int run, std::uint32_t cell);
  std::function<void(const QString&)> failure(const QString& title);

  BackgroundTasks& m_tasks;
  QString m_taskKey;
  PlanSettings m_settings;
  std::shared_ptr<const dictionary::PrincipalComponents> m_basis;
  std::shared_ptr<const dictionary::PrincipalComponents> m_atoms;  ///< of the same materials; null until needed
  QStringList m_learned;                                           ///< materials of m_basis
  study::MaterialClass m_learnedClass = study::MaterialClass::all;
  int m_learnedComponents = 0;                       ///< maximum number of components of m_basis
  std::optional<acquisition::SamplingPlan> m_given;  ///< existing plan to use, if any
  int m_run = 0;  ///< number of the plan, to recognise directions of earlier plans that arrive late
  std::vector<std::uint32_t> m_chosen;
  acquisition::SampleSelection m_selection;
  acquisition::SamplingPlan m_plan;
};

}  // namespace gonio::app
