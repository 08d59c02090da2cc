// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_planner.h"

#include <QCoreApplication>
#include <QDir>
#include <QPointer>
#include <QRegularExpression>
#include <algorithm>

#include "app/gonio/document/material_files.h"
#include "core/acquisition/atom_components.h"
#include "core/materials/bundled_library.h"
#include "core/materials/dictionary_file.h"
#include "core/materials/material.h"
#include "core/materials/material_formats.h"
#include "core/study/learned_basis.h"

namespace gonio::app {

namespace {

struct AcquisitionTrainingText {
  Q_DECLARE_TR_FUNCTIONS(AcquisitionTraining)
};

QStringList libraryIds(const QString& collection) {
  QStringList ids;
  for (const materials::LibraryEntry& entry : materials::bundledLibrary())
    if (const QString id = QString::fromStdString(entry.id); id.startsWith(collection))
      ids << QString::fromUtf8(materials::libraryScheme.data(), qsizetype(materials::libraryScheme.size())) + id;
  return ids;
}

}  // namespace

TrainingSet libraryTraining() {
  QStringList ids;
  for (const std::string& path : materials::libraryTrainingPaths()) ids << QString::fromStdString(path);
  return {AcquisitionTrainingText::tr("measured materials and near-measured copies"), ids};
}
TrainingSet measuredTraining() {
  return {AcquisitionTrainingText::tr("measured materials of the library"), libraryIds(QStringLiteral("rgl/"))};
}
TrainingSet nearMeasuredTraining() {
  return {AcquisitionTrainingText::tr("near-measured copies of MERL"), libraryIds(QStringLiteral("merl-copy/"))};
}
TrainingSet fittedTraining() {
  return {AcquisitionTrainingText::tr("published fits of the library"), libraryIds(QStringLiteral("sgd/"))};
}

TrainingSet folderTraining(const QString& folder) {
  const QDir dir(folder);
  TrainingSet set{AcquisitionTrainingText::tr("files of %1").arg(dir.dirName()), {}};
  for (const QFileInfo& file : dir.entryInfoList(measurementFilePatterns(), QDir::Files | QDir::Readable, QDir::Name))
    if (const materials::MaterialFormat* format = materials::formatOfFile(file.filesystemAbsoluteFilePath());
        format && format->isMeasurement)
      set.ids << file.absoluteFilePath();
  return set;
}

QString baseName(const QString& id) {
  static const QRegularExpression ending(QStringLiteral("(_rgb|_spec)?(\\.[a-z]+)?$"),
                                         QRegularExpression::CaseInsensitiveOption);
  return id.section('/', -1).remove(ending).toLower();
}

QStringList without(const QStringList& ids, const QString& id) {
  if (id.isEmpty()) return ids;
  QStringList kept;
  for (const QString& one : ids)
    if (one != id && baseName(one) != baseName(id)) kept << one;
  return kept;
}

std::shared_ptr<const dictionary::PrincipalComponents> learnLibraryComponents(const QStringList& ids, int components,
                                                                              study::MaterialClass materialClass,
                                                                              const TaskControl& control) {
  if (ids.size() < 2)
    throw Error("The training set has " + std::to_string(ids.size()) + (ids.size() == 1 ? " material" : " materials") +
                "; it needs at least 2.");
  std::vector<std::string> files;
  for (const QString& id : ids) files.push_back(id.toStdString());
  files = study::filesOfClass(files, materialClass, {control.stop, {}});
  if (files.size() < 2)
    throw Error("Only one material of the training set is " +
                std::string(study::materialClassNames[std::size_t(materialClass)]) + "; at least 2 are needed.");
  const auto basis = study::learnedBasis(files, components, materials::BasisPrecision::half, control).basis;
  return {basis, &basis->components};
}

AcquisitionPlanner::AcquisitionPlanner(BackgroundTasks& tasks, QString taskKey, QObject* parent)
    : QObject(parent), m_tasks(tasks), m_taskKey(std::move(taskKey)) {}

std::function<void(const QString&)> AcquisitionPlanner::failure(const QString& title) {
  return [this, title](const QString& error) { Q_EMIT failed(title, error); };
}

bool AcquisitionPlanner::hasLearned(const QString& id) const {
  return !id.isEmpty() && without(m_learned, id) != m_learned;
}

std::shared_ptr<const dictionary::PrincipalComponents> AcquisitionPlanner::learned(
    const QStringList& ids, study::MaterialClass materialClass) const {
  return ids == m_learned && materialClass == m_learnedClass ? m_basis : nullptr;
}

std::vector<DirectionPair> AcquisitionPlanner::directions() const {
  std::vector<DirectionPair> pairs;
  for (const std::uint32_t cell : m_chosen) pairs.push_back(m_basis->mapping.grid.directions(cell));
  return pairs;
}

void AcquisitionPlanner::forget() {
  ++m_run;
  m_chosen.clear();
  m_selection = {};
  m_plan = {};
}

void AcquisitionPlanner::plan(const PlanSettings& settings, const QString& measuredId,
                              const std::optional<acquisition::SamplingPlan>& given) {
  forget();
  m_given = given;
  m_settings = settings;
  if (given) m_settings.samples = int(given->samples.size());
  const QStringList ids =
      settings.leaveOutReference ? without(settings.training.ids, measuredId) : settings.training.ids;
  // The published equation takes as many components as samples.
  const int components = std::max(study::defaultBasisComponents, m_settings.samples);
  if (m_basis && ids == m_learned && settings.materialClass == m_learnedClass && components <= m_learnedComponents)
    choose();
  else
    learn(ids, components);
}

void AcquisitionPlanner::learn(const QStringList& ids, int components) {
  using Basis = std::shared_ptr<const dictionary::PrincipalComponents>;
  // Gigabytes, of a large set: the old one goes before the new one comes.
  m_basis.reset();
  m_atoms.reset();
  m_learned.clear();
  m_tasks.run<Basis>(
      {.title = tr("Learning from %n materials", nullptr, int(ids.size())), .key = m_taskKey, .isLong = true},
      [ids, components, materialClass = m_settings.materialClass](const TaskControl& control) {
        return learnLibraryComponents(ids, components, materialClass, control);
      },
      [this, ids, components, materialClass = m_settings.materialClass](const Basis& basis) {
        m_basis = basis;
        m_learned = ids;
        m_learnedClass = materialClass;
        m_learnedComponents = components;
        choose();
      },
      failure(tr("Cannot learn from the training set")), [this] { Q_EMIT stopped(); });
  Q_EMIT learning();
}

void AcquisitionPlanner::learnAtoms() {
  using Atoms = std::shared_ptr<const dictionary::PrincipalComponents>;
  const int atoms = std::max(acquisition::defaultAtomSignals, m_settings.samples);
  m_tasks.run<Atoms>(
      {.title = tr("Learning coefficients of dictionaries"), .key = m_taskKey, .isLong = true},
      [ids = m_learned, atoms, materialClass = m_learnedClass](const TaskControl& control) {
        constexpr double learned = 0.8;
        const auto dictionary = materials::bundledEnsemble();
        std::vector<std::string> files;
        for (const QString& id : ids) files.push_back(id.toStdString());
        files = study::filesOfClass(files, materialClass, {control.stop, {}});
        const auto prior = acquisition::learnDictionaryPrior(dictionary->ensemble,
                                                             study::trainingMaterials(files, dictionary->ensemble.grid),
                                                             {}, control.between(0, learned));
        return std::make_shared<const dictionary::PrincipalComponents>(
            acquisition::atomComponents(dictionary->ensemble, prior, atoms, control.between(learned, 1)));
      },
      [this](const Atoms& found) {
        m_atoms = found;
        choose();
      },
      failure(tr("Cannot learn from the training set")), [this] { Q_EMIT stopped(); });
  Q_EMIT learning();
}

void AcquisitionPlanner::choose() {
  if (m_given) return takeGiven();
  if (m_settings.overAtoms && (!m_atoms || m_atoms->count() < m_settings.samples)) return learnAtoms();
  acquisition::SelectionOptions options;
  options.method = m_settings.method;
  options.samples = m_settings.samples;
  options.measurable = m_settings.measurable;
  options.seed = m_settings.seed;
  const auto signals = m_settings.overAtoms ? m_atoms : m_basis;
  const auto showCell = [planner = QPointer(this), tasks = &m_tasks, run = m_run](std::uint32_t cell) {
    QMetaObject::invokeMethod(
        tasks,
        [planner, run, cell] {
          if (planner) planner->takeChosen(run, cell);
        },
        Qt::QueuedConnection);
  };
  using Planned = std::pair<acquisition::SampleSelection, acquisition::SamplingPlan>;
  m_tasks.run<Planned>(
      {tr("Choosing %n directions", nullptr, options.samples), m_taskKey},
      [signals, options, showCell](const TaskControl& control) {
        auto selection = acquisition::selectSamples(*signals, options, control, showCell);
        auto plan = acquisition::planFor(signals->mapping.grid, selection.cells);
        return Planned(std::move(selection), std::move(plan));
      },
      [this](const Planned& one) { install(one.first, one.second); }, failure(tr("Cannot choose directions")),
      [this] { Q_EMIT stopped(); });
  Q_EMIT choosing();
}

void AcquisitionPlanner::takeGiven() {
  try {
    acquisition::SampleSelection selection;
    for (const acquisition::PlannedSample& sample : m_given->samples)
      selection.cells.push_back(acquisition::nearestNode(m_basis->mapping.grid, sample.directions));
    install(selection, *m_given);
  } catch (const Error& error) {
    Q_EMIT failed(tr("Cannot use the plan"), QString::fromUtf8(error.what()));
  }
}

void AcquisitionPlanner::install(const acquisition::SampleSelection& selection, const acquisition::SamplingPlan& plan) {
  m_chosen = selection.cells;
  m_selection = selection;
  m_plan = plan;
  Q_EMIT planned();
}

void AcquisitionPlanner::takeChosen(int run, std::uint32_t cell) {
  if (run != m_run || hasPlan()) return;
  m_chosen.push_back(cell);
  Q_EMIT directionChosen();
}

}  // namespace gonio::app

#include "moc_acquisition_planner.cpp"
