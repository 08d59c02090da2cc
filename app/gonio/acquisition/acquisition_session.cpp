// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/acquisition/acquisition_session.h"

#include <QDir>
#include <QPointer>
#include <algorithm>
#include <filesystem>
#include <system_error>

#include "app/gonio/document/material_files.h"
#include "core/materials/encode.h"
#include "core/materials/material.h"
#include "widgets/inputs/menu_text.h"

namespace gonio::app {

namespace {
const QString acquisitionReferenceKey = QStringLiteral("acquisition reference");
/// Of the progress: making a table, then rendering its picture.
constexpr double tableFraction = 0.4;
}  // namespace

ReferenceReader::ReferenceReader(BackgroundTasks& tasks, QObject* parent) : QObject(parent), m_tasks(tasks) {}

bool ReferenceReader::isReading() const { return m_tasks.isRunning(acquisitionReferenceKey); }

void ReferenceReader::read(const QString& id) {
  m_id = id;
  m_name = id.section('/', -1);
  start(
      [id, picture = m_picture](const TaskControl& control) { return readAcquisitionReference(id, picture, control); });
}

void ReferenceReader::read(const QString& id, const QString& name, TableFactory makeTable) {
  m_id = id;
  m_name = name;
  start([id, name, make = std::move(makeTable), picture = m_picture](const TaskControl& control) {
    return acquisitionReference(id, name, make(control.between(0, tableFraction)), picture,
                                control.between(tableFraction, 1));
  });
}

void ReferenceReader::start(std::function<AcquisitionReferencePtr(const TaskControl&)> make) {
  m_reference.reset();
  m_tasks.run<AcquisitionReferencePtr>(
      {tr("Preparing %1").arg(widgets::spacedName(m_name)), acquisitionReferenceKey}, std::move(make),
      [this](const AcquisitionReferencePtr& reference) { finish(reference); },
      [this](const QString& error) {
        const QString name = m_name;
        clear();
        Q_EMIT failed(tr("Cannot measure %1").arg(name), error);
      },
      [this] { clear(); });
  Q_EMIT changed();
}

void ReferenceReader::clear() {
  m_tasks.drop(acquisitionReferenceKey);
  m_id.clear();
  m_name.clear();
  finish(nullptr);
}

void ReferenceReader::finish(const AcquisitionReferencePtr& reference) {
  m_reference = reference;
  if (reference) m_name = reference->name;
  Q_EMIT changed();
  Q_EMIT finished();
}

namespace {
const QString openResultKey = QStringLiteral("open acquisition");

/// A file of this name that is not there yet: "name.binary", "name 2.binary". Another document may stand on the first.
QString freePath(const QString& folder, QString name) {
  name.replace('/', '-');
  QString path = QDir(folder).filePath(name + tableSuffix());
  for (int i = 2; QFile::exists(path); ++i)
    path = QDir(folder).filePath(QStringLiteral("%1 %2%3").arg(name).arg(i).arg(tableSuffix()));
  return path;
}
}  // namespace

AcquisitionSession::AcquisitionSession(BackgroundTasks& tasks, QObject* parent)
    : QObject(parent), m_tasks(tasks), m_referenceReader(tasks), m_planner(tasks, stepKey, this) {
  connect(&m_tasks, &BackgroundTasks::changed, this, &AcquisitionSession::progressed);
  connect(&m_referenceReader, &ReferenceReader::finished, this, &AcquisitionSession::followReference);
  connect(&m_referenceReader, &ReferenceReader::failed, this, &AcquisitionSession::failed);
  connectPlanner();
}

void AcquisitionSession::connectPlanner() {
  connect(&m_planner, &AcquisitionPlanner::learning, this, [this] { setStep(Step::learning); });
  connect(&m_planner, &AcquisitionPlanner::choosing, this, [this] { setStep(Step::choosing); });
  connect(&m_planner, &AcquisitionPlanner::directionChosen, this, &AcquisitionSession::directionsChanged);
  connect(&m_planner, &AcquisitionPlanner::stopped, this, &AcquisitionSession::cancel);
  connect(&m_planner, &AcquisitionPlanner::planned, this, [this] {
    setStep(Step::idle);
    Q_EMIT directionsChanged();
    Q_EMIT planChanged();
    if (m_simulated) measureReference();
  });
  connect(&m_planner, &AcquisitionPlanner::failed, this, [this](const QString& title, const QString& text) {
    setStep(Step::idle);
    Q_EMIT failed(title, text);
  });
}

// --- The plan

void AcquisitionSession::plan(const PlanSettings& settings, const std::optional<acquisition::SamplingPlan>& given) {
  m_tasks.drop(stepKey);
  forgetPlan();
  m_planner.plan(settings, m_referenceReader.id(), given);
}

void AcquisitionSession::forgetPlan() {
  m_planner.forget();
  m_values = {};
  m_simulated = true;
  forgetResult();
  Q_EMIT directionsChanged();
  Q_EMIT planChanged();
  Q_EMIT valuesChanged();
}

void AcquisitionSession::forgetResult() {
  m_result.reset();
  m_curve.clear();
  Q_EMIT resultChanged();
  Q_EMIT curveChanged();
}

void AcquisitionSession::setStep(Step step) {
  m_step = step;
  Q_EMIT progressed();
}

double AcquisitionSession::fraction() const {
  const auto task = m_tasks.topmost();
  return task && isBusy() ? task->fraction : 0;
}

std::function<void(const QString&)> AcquisitionSession::failure(const QString& title) {
  return [this, title](const QString& error) {
    setStep(Step::idle);
    Q_EMIT failed(title, error);
  };
}

std::function<void()> AcquisitionSession::stopped() {
  return [this] { cancel(); };
}

void AcquisitionSession::cancel() {
  m_tasks.drop(stepKey);
  // A stopped search leaves an incomplete plan, which is discarded.
  const bool unfinished = m_step == Step::learning || m_step == Step::choosing;
  setStep(Step::idle);
  if (unfinished) forgetPlan();
}

// --- The material that is measured

void AcquisitionSession::followReference() {
  if (m_step == Step::learning || m_step == Step::choosing) return;
  if (m_simulated) return measureReference();
  if (m_planner.hasPlan() && !m_values.rgb.empty()) reconstruct();
}

// --- The values

void AcquisitionSession::simulate(const acquisition::MeasurementNoise& noise) {
  m_noise = noise;
  m_simulated = true;
  if (m_planner.hasPlan()) measureReference();
}

void AcquisitionSession::measureReference() {
  forgetResult();
  m_values = {};
  if (m_planner.hasPlan() && m_referenceReader.reference()) {
    try {
      m_values = acquisition::measure(*m_referenceReader.reference()->table, m_planner.samplingPlan(), m_noise);
    } catch (const Error& error) {
      Q_EMIT failed(tr("Cannot measure %1").arg(m_referenceReader.name()), QString::fromUtf8(error.what()));
    }
    m_valuesName = tr("simulated from %1").arg(m_referenceReader.name());
    m_valuesOf = m_referenceReader.name();
  }
  Q_EMIT valuesChanged();
  if (!m_values.rgb.empty()) return reconstruct();
  // What runs would report on values that are gone.
  m_tasks.drop(stepKey);
  setStep(Step::idle);
}

void AcquisitionSession::setValues(const acquisition::MeasuredValues& values, const QString& name) {
  if (values.rgb.size() != m_planner.samplingPlan().samples.size())
    throw Error("found " + std::to_string(values.rgb.size()) + " values, expected one for each of the plan's " +
                std::to_string(m_planner.samplingPlan().samples.size()) + " samples");
  m_simulated = false;
  m_values = values;
  m_valuesName = name;
  m_valuesOf = name.contains('.') ? name.section('.', 0, -2) : tr("Material");
  forgetResult();
  Q_EMIT valuesChanged();
  reconstruct();
}

// --- The material

void AcquisitionSession::setReconstruction(const acquisition::ReconstructionOptions& options) {
  m_options = options;
  if (m_planner.hasPlan() && !m_values.rgb.empty()) reconstruct();
}

AcquisitionInput AcquisitionSession::input() const {
  return {m_planner.basis(), m_planner.samplingPlan(), m_values, m_options};
}

void AcquisitionSession::reconstruct() {
  m_curve.clear();
  Q_EMIT curveChanged();
  m_tasks.run<AcquisitionResultPtr>(
      {tr("Reconstructing the material"), stepKey},
      [input = input(), reference = m_referenceReader.reference()](const TaskControl& control) {
        return acquire(input, reference, control);
      },
      [this, input = input(), of = m_valuesOf](const AcquisitionResultPtr& result) {
        m_result = result;
        m_resultOf = of;
        setStep(Step::idle);
        Q_EMIT resultChanged();
        if (m_referenceReader.reference()) startCurve(input);
      },
      failure(tr("Cannot reconstruct the material")), stopped());
  setStep(Step::reconstructing);
}

void AcquisitionSession::startCurve(const AcquisitionInput& input) {
  const auto showError = [session = QPointer(this), tasks = &m_tasks, result = m_result](
                             int samples, const AcquisitionError& error) {
    QMetaObject::invokeMethod(
        tasks,
        [session, result, samples, error] {
          if (!session || session->m_result != result) return;
          session->m_curve.push_back({samples, error});
          Q_EMIT session->curveChanged();
        },
        Qt::QueuedConnection);
  };
  m_tasks.run<bool>(
      {.title = tr("Computing the error curve"), .key = stepKey, .isLong = true},
      [input, reference = m_referenceReader.reference(), showError](const TaskControl& control) {
        measureCurve(input, reference, showError, control);
        return true;
      },
      [this](bool) { setStep(Step::idle); }, failure(tr("Cannot compute the error curve")), stopped());
  setStep(Step::measuringCurve);
}

QString AcquisitionSession::resultName() const {
  return tr("%1 from %n samples", nullptr, int(m_planner.samplingPlan().samples.size())).arg(m_resultOf);
}

void AcquisitionSession::open(const QString& folder) {
  if (m_result) openTable(m_result->reconstruction->table, resultName(), folder);
}

void AcquisitionSession::openTable(std::shared_ptr<const TabulatedBrdf> table, const QString& name,
                                   const QString& folder) {
  m_tasks.run<LoadedMaterialPtr>(
      {tr("Opening %1").arg(name), openResultKey},
      [table = std::move(table), folder, name](const TaskControl& control) {
        std::error_code cause;
        std::filesystem::create_directories(folder.toStdString(), cause);
        if (!std::filesystem::is_directory(folder.toStdString()))
          throw Error(folder.toStdString() + ": the folder cannot be created: " + cause.message());
        const std::string path = freePath(folder, name).toStdString();
        materials::writeMaterial(materials::unedited(name.toStdString(), table), path, {}, control);
        return loadMaterial(path, control);
      },
      [this, name](const LoadedMaterialPtr& material) { Q_EMIT materialMade(material, tr("Open %1").arg(name)); },
      [this, name](const QString& error) { Q_EMIT failed(tr("Cannot open %1").arg(name), error); });
}

bool AcquisitionSession::isOpening() const { return m_tasks.isRunning(openResultKey); }

}  // namespace gonio::app

#include "moc_acquisition_session.cpp"
